// Where the tests find files and the program, as CMake was told.
#pragma once

#include <string>

namespace pectin::test {

// A path within the project, such as "assets/demo.jsonl".
std::string source_path(const std::string& relative);
// The folder of real models (CMake option PECTIN_MODELS), which may be absent.
std::string models_folder();
// The model called NAME.obj in it.
std::string model_path(const std::string& name);
// Where tests write the pictures that they draw.
std::string pictures_folder();
// The program pectin.
std::string program_path();

}  // namespace pectin::test
