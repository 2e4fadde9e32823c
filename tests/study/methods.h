// The ways of refining that are compared, as data.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "session/settings.h"
#include "study/printed_rules.h"
#include "study/scene.h"

namespace pectin::study {

// A trigger of the program.
struct Trigger {
    std::string name;
    command::Adapt::Trigger trigger;
    bool by_tolerance;   // its parameter is a tolerance and not an angle
    bool limits_length;  // by default L_max acts beside it
};
// All that the command `adapt` knows.
const std::vector<Trigger>& triggers();

// What refining a scene has done.
struct Refined {
    std::uint64_t splits = 0;
    bool has_ended = true;
    double seconds = 0.0;
};

struct Method {
    std::string name;
    std::string parameter;        // what it is: "theta_max", "tolerance" (in diagonals), "rounds"
    std::vector<double> details;  // its values, from coarse to fine
    std::function<Refined(const Case&, Scene&, double detail)> refine;
};

// With most_faces the mesh is fine enough; a method that needs more counts as not ended.
inline constexpr std::uint64_t kMostFaces = 60'000;

// The settings of the program with this trigger and this value of its parameter.
AdaptSettings settings_of(const Trigger& trigger, const Case& of, double detail);
// What a drag of a session makes of them.
AdaptLimits limits_of(const AdaptSettings& settings, const Case& of);

// Uniform subdivision, the printed rules in both orders, and each trigger of the program, with its
// L_max and without.
std::vector<Method> methods();

}  // namespace pectin::study
