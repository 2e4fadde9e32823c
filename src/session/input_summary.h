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

// The findings that the user should know, each with its count; texts without findings are empty.
struct InputFindings {
    std::string dropped;  // each with the line where it occurs first; separated by semicolons
    std::string repairs;  // such as "2 non-manifold edges split, 4 shared vertices"
    std::string kept;     // nothing is wrong with it, such as "1,113 unused vertices kept"
};
InputFindings input_findings(const BuildReport& report, const ReadReport& read = {});

// Returns one sentence with these findings, such as "beetle.obj: opened with repairs: 47
// non-manifold edges split; 2 unused vertices kept". Empty if there are none.
std::string input_summary(const std::string& path, const BuildReport& report,
                          const ReadReport& read = {});

}  // namespace pectin
