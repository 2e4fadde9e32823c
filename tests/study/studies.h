// The parts of the study. Each returns what it has measured, for tests/study/report.py to show.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace pectin::study {

using Json = nlohmann::ordered_json;

struct Options {
    std::string models;   // a folder of real models; may be empty or absent
    int repetitions = 5;  // of whatever is timed; the median counts
};

// The paper's figure 5: operations and time for each test of an edge; and the bit index of cells.
Json study_edge_tests(const Options& options);
// The paper's figures 4 and 6: what the pictures show.
Json study_figures(const Options& options);
// The paper's figure 7: an extrusion and a flattening.
Json study_extrusion(const Options& options);
// Error over the number of triangles, by method, on twelve objects and drags.
Json study_errors(const Options& options);
// Longest-edge propagation with several factors.
Json study_propagation(const Options& options);
// Decimation beside other libraries.
Json study_decimation(const Options& options);

}  // namespace pectin::study
