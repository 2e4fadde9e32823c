// Longest-edge propagation (Parry's long-side rule, made exact) with several factors rho. The tests
// of Propagation show that with rho = 1 every split edge is the longest at rest of both its faces.
//
// Source: S. Parry. Free-form deformations in a constructive solid geometry modeling system. PhD
// thesis, Brigham Young University 1986, as Gain & Dodgson 1999, section 1, describe it.
#include "adapt/adapt.h"
#include "study/cases.h"
#include "study/methods.h"
#include "study/studies.h"
#include "study/true_error.h"

namespace pectin::study {
namespace {

constexpr double kThetaMax = 9.0;

Json with_factor(const Case& of, double factor, int repetitions) {
    AdaptSettings settings = settings_of(triggers().front(), of, kThetaMax);
    settings.propagation = factor;
    const AdaptLimits limits = limits_of(settings, of);
    Json result;
    const double time = median_of(static_cast<std::size_t>(repetitions), [&] {
        Scene scene(of.mesh, of.warp);
        Refinement done;
        const double passed = seconds(
            [&] { done = refine(scene.active(), scene.embedding(), scene.criteria(limits)); });
        if (result.empty()) {
            const std::vector<FaceId> faces = scene.faces();
            const Angles angles = smallest_angles(scene, faces);
            result = {{"faces", faces.size()},
                      {"splits", done.splits},
                      {"chain_steps", done.chain_steps},
                      {"from_mesh", true_error(scene, faces).from_mesh / of.diagonal()},
                      {"smallest_angle", angles.smallest},
                      {"median_angle", angles.median}};
        }
        return passed;
    });
    result["seconds"] = time;
    return result;
}

}  // namespace

Json study_propagation(const Options& options) {
    const Cases all = twelve_cases(options.models);
    Json factors = Json::array();
    for (const double factor : {1.0, 1.1, 1.2, 1.3, 1.4, 1.49}) {
        Json cases = Json::array();
        for (const Case& of : all.cases) {
            cases.push_back(with_factor(of, factor, options.repetitions));
        }
        factors.push_back({{"factor", factor}, {"cases", cases}});
    }
    return {{"theta_max", kThetaMax}, {"has_models", all.has_models}, {"factors", factors}};
}

}  // namespace pectin::study
