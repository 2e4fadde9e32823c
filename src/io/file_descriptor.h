// An open file of the operating system, closed with its owner.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace pectin {

class FileDescriptor {
  public:
    // Opens as open(2) does; not is_open(), with errno set, where that fails.
    FileDescriptor(const char* path, int flags, mode_t mode = 0) {
        do {
            descriptor_ = ::open(path, flags | O_CLOEXEC, mode);
        } while (descriptor_ < 0 && errno == EINTR);
    }
    FileDescriptor() = default;
    ~FileDescriptor() { close(); }
    FileDescriptor(FileDescriptor&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }

    bool is_open() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    // Whether the system had nothing to complain of, such as a late write error on a network
    // drive; EINTR is no complaint, for Linux has closed by then.
    bool close() {
        const int descriptor = std::exchange(descriptor_, -1);
        return descriptor < 0 || ::close(descriptor) == 0 || errno == EINTR;
    }

  private:
    int descriptor_ = -1;
};

}  // namespace pectin
