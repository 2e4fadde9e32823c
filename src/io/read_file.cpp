#include "io/read_file.h"

#include <algorithm>

#include "io/file_error.h"
#include "io/open_file.h"

namespace pectin {

std::string read_whole_file(const std::string& path, const Progress& progress,
                            std::size_t max_bytes) {
    const OpenFile file = open_file(path, progress);
    const auto refuse_beyond_most = [&](std::size_t size) {
        if (size <= max_bytes) return;
        throw FileError(path, "is larger than " + std::to_string(max_bytes >> 20) + " MB");
    };
    const std::size_t expected = file.bytes;  // 0 for files that the system generates, as in /proc
    refuse_beyond_most(expected);

    // One byte more than the file has, so that the read that fills it also finds the end.
    constexpr std::size_t kMinBuffer = 4096;
    constexpr std::size_t kMaxAtOnce = std::size_t{4} << 20;
    std::string bytes(std::max(kMinBuffer, expected + 1), '\0');
    std::size_t size = 0;
    while (true) {
        if (size == bytes.size()) bytes.resize(2 * bytes.size());
        const std::size_t piece = std::min(kMaxAtOnce, bytes.size() - size);
        const std::size_t got = read_bytes(file, path, bytes.data() + size, piece);
        size += got;
        refuse_beyond_most(size);
        progress.advance(size < expected ? static_cast<double>(size) / static_cast<double>(expected)
                                         : 1.0);
        if (got < piece) break;
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace pectin
