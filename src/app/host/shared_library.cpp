#include "app/host/shared_library.h"

#include <dlfcn.h>

namespace pectin {

// RTLD_LOCAL: OSMesa and libGL define the same functions, which must not replace each other.
// RTLD_NODELETE: a leak checker can name the functions of a driver only while it is loaded.
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
