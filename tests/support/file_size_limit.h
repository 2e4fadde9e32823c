// A limit on the size of the files that the test writes.
#pragma once

#include <signal.h>
#include <sys/resource.h>

#include <cstdint>

namespace pectin {

// Limits the size of all files that this process writes, for the lifetime of the object.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(std::uintmax_t bytes) {
        struct sigaction ignore {};
        ignore.sa_handler = SIG_IGN;
        ::sigaction(SIGXFSZ, &ignore, &before_);
        ::getrlimit(RLIMIT_FSIZE, &limit_);
        const rlimit lower{static_cast<rlim_t>(bytes), limit_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &lower);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &limit_);
        ::sigaction(SIGXFSZ, &before_, nullptr);
    }

  private:
    rlimit limit_{};
    struct sigaction before_ {};
};

}  // namespace pectin
