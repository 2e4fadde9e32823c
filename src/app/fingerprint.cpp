#include "app/fingerprint.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "io/open_file.h"

namespace pectin {
namespace {

// FNV-1a on words of eight bytes. The shift carries high bits down.
class Hash {
  public:
    // Precondition: in all calls but the last one the length is a multiple of eight bytes.
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

std::string as_word(std::size_t length, std::uint64_t hash) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%zu-%016llx", length,
                  static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace

std::string fingerprint(const std::string& path, const Progress& progress,
                        const std::function<void(std::string_view)>& consume) {
    constexpr std::size_t kPart = std::size_t{1} << 20;
    FileAccess access;
    const OpenFile file = access.open(path, progress);
    Hash hash;
    std::size_t done = 0;
    while (true) {
        const std::string bytes = access.read(file, path, done, kPart, progress);
        if (bytes.empty()) break;
        hash.add(bytes);
        if (consume) consume(bytes);
        done += bytes.size();
    }
    return as_word(done, hash.value());
}

}  // namespace pectin
