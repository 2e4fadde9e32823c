#include "app/model_copy.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/atomic_file.h"
#include "io/file_error.h"
#include "io/open_file.h"

namespace pectin {
namespace {

// FNV-1a on words of eight bytes, with a shift that carries high bits down.
class Hash {
  public:
    // All calls but the last one: a multiple of eight bytes.
    void add(std::string_view bytes) {
        for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
            const std::string_view part = bytes.substr(at, sizeof(std::uint64_t));
            std::uint64_t word = 0;
            std::memcpy(&word, part.data(), part.size());
            value_ = (value_ ^ word) * 0x100000001b3u;
            value_ ^= value_ >> 32;
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325u;
};

// The file's fingerprint. sink: gets all of its bytes, part by part.
template <typename Sink>
std::string read_through(const std::string& path, const Progress& progress, Sink sink) {
    constexpr std::size_t kPart = std::size_t{1} << 20;
    const OpenFile file = open_file(path, progress);
    std::vector<char> part(kPart);
    Hash hash;
    std::size_t done = 0;
    while (const std::size_t count = read_bytes(file, path, part.data(), part.size())) {
        const std::string_view bytes(part.data(), count);
        hash.add(bytes);
        sink(bytes);
        done += count;
        if (file.bytes > 0) {
            progress.advance(
                std::min(1.0, static_cast<double>(done) / static_cast<double>(file.bytes)));
        }
    }
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%zu-%016llx", done,
                  static_cast<unsigned long long>(hash.value()));
    return text.data();
}

}  // namespace

std::string fingerprint(const std::string& path, const Progress& progress) {
    return read_through(path, progress, [](std::string_view) {});
}

void make_copy(const ModelCopy& copy, const Progress& progress) {
    // Readable for its owner alone, as the original may be: the new contents keep the permissions.
    FileDescriptor(copy.to.c_str(), O_WRONLY | O_CREAT, 0600).close();
    try {
        AtomicFile file(copy.to);
        const std::string found = read_through(
            copy.from, progress, [&file](std::string_view bytes) { file.write(bytes); });
        if (found != copy.fingerprint) {
            throw FileError(copy.from, "was changed by another program after it was opened");
        }
        file.commit();
    } catch (...) {
        ::unlink(copy.to.c_str());
        throw;
    }
}

LoadedModel load_original(const command::Open& open, const ModelCopy& copy,
                          const Progress& progress) {
    constexpr double kCompared = 0.1;  // of the time that it takes
    std::error_code ignored;
    const bool has_copy = std::filesystem::file_size(copy.from, ignored) > 0 && !ignored &&
                          fingerprint(copy.from, progress.part(0.0, kCompared)) == copy.fingerprint;
    if (!has_copy && fingerprint(open.path, progress.part(0.0, kCompared)) != copy.fingerprint) {
        throw FileError(open.path,
                        "was changed after the session had opened it; put the earlier file back "
                        "to restore the session");
    }
    LoadedModel model =
        load_model({.path = has_copy ? copy.from : open.path, .crease_angle = open.crease_angle},
                   progress.part(kCompared, 1.0));
    model.material_folders = {material_folder(open.path)};
    if (has_copy && !copy.to.empty()) {
        // Both are in the state folder as a rule, and then one file with two names will do.
        std::filesystem::create_hard_link(copy.from, copy.to, ignored);
        if (ignored) make_copy(copy);
    }
    return model;
}

}  // namespace pectin
