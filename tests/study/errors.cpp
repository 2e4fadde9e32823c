// Error over the number of triangles, by method, on twelve objects and drags; and what the default
// settings of each trigger make of them.
#include <cstdio>
#include <vector>

#include "adapt/adapt.h"
#include "study/cases.h"
#include "study/methods.h"
#include "study/studies.h"
#include "study/true_error.h"

namespace pectin::study {
namespace {

Json outcome(const Scene& scene, const Case& of) {
    const std::vector<FaceId> faces = scene.faces();
    const TrueError error = true_error(scene, faces);
    const Angles angles = smallest_angles(scene, faces);
    return {{"faces", faces.size()},
            {"from_mesh", error.from_mesh / of.diagonal()},
            {"from_face", error.from_face / of.diagonal()},
            {"from_face_rms", error.from_face_rms / of.diagonal()},
            {"from_interpolation", error.from_interpolation / of.diagonal()},
            {"smallest_angle", angles.smallest},
            {"median_angle", angles.median}};
}

// All points of a curve. It ends where the method reaches the largest number of faces.
Json curve(const Method& method, const Case& of) {
    Json points = Json::array();
    for (const double detail : method.details) {
        Scene scene(of.mesh, of.warp);
        const Refined done = method.refine(of, scene, detail);
        Json point{{"detail", detail}, {"has_ended", done.has_ended}};
        if (!done.has_ended) {
            point["faces"] = scene.faces().size();
            points.push_back(point);
            // By the printed rules a finer angle may end where a coarser one did not.
            if (method.parameter == "theta_max" && points.size() < 3) continue;
            break;
        }
        point.update(outcome(scene, of));
        points.push_back(point);
    }
    return {{"name", method.name}, {"parameter", method.parameter}, {"points", points}};
}

// A trigger with the settings that the program has by default.
Json by_default(const Trigger& trigger, const Case& of, int repetitions) {
    const AdaptLimits limits = limits_of(*AdaptSettings{}.with({.trigger = trigger.trigger}), of);
    Json result;
    const double time = median_of(static_cast<std::size_t>(repetitions), [&] {
        Scene scene(of.mesh, of.warp);
        Adaptation done;
        const double passed = seconds(
            [&] { done = adapt(scene.active(), scene.embedding(), scene.criteria(limits)); });
        if (result.empty()) {
            result = outcome(scene, of);
            result["splits"] = done.refinement.splits;
        }
        return passed;
    });
    result["trigger"] = trigger.name;
    result["seconds"] = time;
    return result;
}

}  // namespace

Json study_errors(const Options& options) {
    const Cases all = twelve_cases(options.models);
    Json cases = Json::array();
    for (const Case& of : all.cases) {
        std::fprintf(stderr, "errors: %s, %s\n", of.object.c_str(), of.drag.c_str());
        Json curves = Json::array(), defaults = Json::array();
        for (const Method& method : methods()) curves.push_back(curve(method, of));
        for (const Trigger& trigger : triggers()) {
            defaults.push_back(by_default(trigger, of, options.repetitions));
        }
        const Scene scene(of.mesh, of.warp);
        cases.push_back({{"object", of.object},
                         {"drag", of.drag},
                         {"steps", of.warp.steps.size()},
                         {"faces_at_rest", scene.faces().size()},
                         {"curves", curves},
                         {"defaults", defaults}});
    }
    return {{"has_models", all.has_models}, {"most_faces", kMostFaces}, {"cases", cases}};
}

}  // namespace pectin::study
