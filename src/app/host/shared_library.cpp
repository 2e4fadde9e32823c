#include "app/host/shared_library.h"

#include <dlfcn.h>

namespace pectin {

// RTLD_LOCAL: OSMesa defines the same functions as libGL, which must not be mixed up.
// RTLD_NODELETE: a leak checker can name what a driver leaks only while the driver is in memory.
SharedLibrary::SharedLibrary(const char* name)
    : name_(name), handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
    if (!handle_) throw ContextError(dlerror());
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

void* SharedLibrary::address_of(const char* function) const {
    void* const found = dlsym(handle_, function);
    if (!found) throw ContextError(name_ + " has no function " + function);
    return found;
}

}  // namespace pectin
