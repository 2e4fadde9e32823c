// Runs a part of the study and writes what it has measured as JSON. scripts/study runs them all.
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <string>

#include "study/studies.h"

namespace {

using pectin::study::Json;
using pectin::study::Options;

const std::map<std::string, Json (*)(const Options&)>& studies() {
    using namespace pectin::study;
    static const std::map<std::string, Json (*)(const Options&)> kStudies{
        {"edge_tests", study_edge_tests},   {"figures", study_figures},
        {"extrusion", study_extrusion},     {"errors", study_errors},
        {"propagation", study_propagation}, {"decimation", study_decimation},
    };
    return kStudies;
}

int usage() {
    std::fputs(
        "usage: pectin_study PART FILE [FOLDER [REPETITIONS]]\n"
        "  Writes the results of a part of the study to FILE. FOLDER has real models.\n"
        "  Parts:",
        stderr);
    for (const auto& [name, study] : studies()) std::fprintf(stderr, " %s", name.c_str());
    std::fputs("\n", stderr);
    return 2;
}

}  // namespace

int main(int count, char** arguments) {
    const auto study = count >= 3 ? studies().find(arguments[1]) : studies().end();
    if (study == studies().end()) return usage();
    try {
        Options options;
        if (count > 3) options.models = arguments[3];
        if (count > 4) options.repetitions = std::stoi(arguments[4]);
        std::ofstream file(arguments[2]);
        file << study->second(options).dump(1) << '\n';
        file.close();
        if (!file) throw std::runtime_error(std::string(arguments[2]) + " cannot be written");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pectin_study: %s\n", error.what());
        return 1;
    }
    return 0;
}
