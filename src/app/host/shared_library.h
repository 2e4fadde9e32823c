// A library that is opened at run time, so that the program starts without it.
#pragma once

#include <string>

#include "render/gl.h"

namespace pectin {

class SharedLibrary {
  public:
    // Throws ContextError, with the loader's reason, if the library cannot be opened.
    explicit SharedLibrary(const char* name);
    ~SharedLibrary();
    SharedLibrary(const SharedLibrary&) = delete;
    SharedLibrary& operator=(const SharedLibrary&) = delete;

    // Function: the type of the function. Throws ContextError if the library has no such function.
    template <class Function>
    Function* find(const char* function) const {
        return reinterpret_cast<Function*>(address_of(function));
    }

  private:
    void* address_of(const char* function) const;

    std::string name_;
    void* handle_;
};

}  // namespace pectin
