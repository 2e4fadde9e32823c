// What was found in a model's input and done about it, for people and for `stats`.
#pragma once

#include <string>
#include <vector>

#include "command/statistics.h"
#include "io/read_report.h"
#include "mesh/build_mesh.h"

namespace pectin {

// All counts of the reports, by their names in `stats`.
std::vector<Statistics::Count> input_counts(const BuildReport& report, const ReadReport& read = {});

// "beetle.obj: 47 edges cut ...; 2 isolated vertices": what is worth telling, in one sentence that
// begins with the file's name. First comes what was dropped, each with the line where it is found
// first. Empty where all is as it should be.
std::string input_summary(const std::string& path, const BuildReport& report,
                          const ReadReport& read = {});

}  // namespace pectin
