#include "io/read_file.h"

#include <algorithm>

#include "io/file_error.h"

namespace pectin {

std::string read_whole_file(const std::string& path, const Progress& progress,
                            std::size_t max_bytes, const FileOptions& options) {
    FileAccess access(options);
    const OpenFile file = access.open(path, progress);
    const auto refuse_beyond_most = [&](std::size_t size) {
        if (size <= max_bytes) return;
        throw FileError(path, "is larger than " + std::to_string(max_bytes >> 20) + " MB");
    };
    const std::size_t expected = file.bytes;  // 0 for files that the system generates, as in /proc
    refuse_beyond_most(expected);

    // One byte more than the file has, so that the read that fills it also finds the end.
    constexpr std::size_t kLeast = 4096;
    std::size_t most = std::max(kLeast, expected + 1);
    std::string bytes = access.read(file, path, 0, most, progress);
    while (bytes.size() == most) {
        refuse_beyond_most(bytes.size());
        bytes += access.read(file, path, most, most, progress);
        most *= 2;
    }
    refuse_beyond_most(bytes.size());
    progress.advance(1.0);
    return bytes;
}

}  // namespace pectin
