// Summarises what was found in the input of a model, for the user and for `stats`.
#pragma once

#include <string>
#include <vector>

#include "command/statistics.h"
#include "io/read_report.h"
#include "mesh/build_mesh.h"

namespace pectin {

// All counts of the reports with their names in `stats`.
std::vector<Statistics::Count> input_counts(const BuildReport& report, const ReadReport& read = {});

// Returns one sentence with the findings that the user should know, such as "beetle.obj: 47 edges
// cut ...; 2 isolated vertices". It begins with the name of the file and with what was dropped,
// each with the line where it occurs first. Empty if there are no such findings.
std::string input_summary(const std::string& path, const BuildReport& report,
                          const ReadReport& read = {});

}  // namespace pectin
