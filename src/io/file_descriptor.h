// Owns an open file of the operating system.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace pectin {

class FileDescriptor {
  public:
    // Opens the file as open(2) does. If this fails, is_open() is false and errno is set.
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
    // Returns false if the system reports an error, such as a late write error on a network drive.
    // EINTR is not an error, because Linux has closed the file by then.
    bool close() {
        const int descriptor = std::exchange(descriptor_, -1);
        return descriptor < 0 || ::close(descriptor) == 0 || errno == EINTR;
    }

  private:
    int descriptor_ = -1;
};

}  // namespace pectin
