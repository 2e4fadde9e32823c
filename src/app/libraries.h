// The program's version and the libraries that it is built with.
#pragma once

#include <span>
#include <string>

namespace pectin {

std::string program_version();

struct Library {
    std::string name;
    std::string version;
};
// By name. The versions are those of the headers that the program was compiled with.
std::span<const Library> libraries();

}  // namespace pectin
