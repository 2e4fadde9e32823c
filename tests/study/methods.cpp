#include "study/methods.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "adapt/adapt.h"
#include "command/schema.h"

namespace pectin::study {
namespace {

// From `first` on, each `factor` times the one before.
std::vector<double> geometric(double first, double factor, int count) {
    std::vector<double> values{first};
    for (int i = 1; i < count; ++i) values.push_back(values.back() * factor);
    return values;
}

// One round bisects every face, at the edge that is longest at rest. Two rounds halve all edges.
Refined subdivide(Scene& scene, int rounds) {
    Refined done;
    done.seconds = seconds([&] {
        for (int i = 0; i < rounds; ++i) {
            const std::vector<FaceId> faces = scene.faces();
            if (2 * faces.size() > kMostFaces) {
                done.has_ended = false;
                return;
            }
            std::vector<EdgeId> longest;
            for (const FaceId f : faces) {
                const TriMesh& mesh = scene.mesh();
                EdgeId of_face = kNone<EdgeId>;
                for (int k = 0; k < 3; ++k) {
                    const EdgeId e = mesh.representative(mesh.edge(TriMesh::half_edge(f, k)));
                    if (!exists(of_face) ||
                        scene.active().rest_length(e) > scene.active().rest_length(of_face)) {
                        of_face = e;
                    }
                }
                longest.push_back(of_face);
            }
            std::ranges::sort(longest);
            longest.erase(std::unique(longest.begin(), longest.end()), longest.end());
            done.splits +=
                refine_at(scene.active(), scene.embedding(), scene.criteria({}), longest).splits;
        }
    });
    return done;
}

Refined refine_by(const AdaptLimits& limits, Scene& scene) {
    Refined done;
    done.seconds = seconds([&] {
        const Adaptation adaptation =
            adapt(scene.active(), scene.embedding(), scene.criteria(limits));
        done.splits = adaptation.refinement.splits;
        done.has_ended = !adaptation.refinement.budget_hit;
    });
    return done;
}

Refined refine_by_print(const Case& of, Scene& scene, Order order, double theta_max) {
    const PrintedRules rules{.curvature = NormalDivergence({.theta_max = theta_max}),
                             .l_max = default_l_max(of.warp.smallest_feature_extent()),
                             .order = order,
                             .most_faces = scene.mesh().face_count() + kMostFaces};
    Refined done;
    done.seconds = seconds([&] {
        const PrintedRefinement printed = refine_as_printed(scene, rules);
        done.splits = printed.splits;
        done.has_ended = printed.has_ended;
    });
    return done;
}

const std::vector<double> kAngles = geometric(64.0, 0.7071, 12);
const std::vector<double> kTolerances = geometric(2e-2, 0.5, 11);

Method product_method(const Trigger& trigger, bool has_l_max) {
    return {.name = trigger.name + (has_l_max || !trigger.limits_length ? "" : ", no L_max"),
            .parameter = trigger.by_tolerance ? "tolerance" : "theta_max",
            .details = trigger.by_tolerance ? kTolerances : kAngles,
            .refine = [trigger, has_l_max](const Case& of, Scene& scene, double detail) {
                AdaptSettings settings = settings_of(trigger, of, detail);
                if (!has_l_max) settings.l_max = Setting::off();
                return refine_by(limits_of(settings, of), scene);
            }};
}

Method printed_method(Order order) {
    return {.name = order == Order::longest_first ? "printed" : "printed, first come",
            .parameter = "theta_max",
            .details = kAngles,
            .refine = [order](const Case& of, Scene& scene, double detail) {
                return refine_by_print(of, scene, order, detail);
            }};
}

}  // namespace

// Another trigger of the program joins the study with its word in the schema. L_max is on beside it
// unless the settings for a drag switch it off by themselves.
const std::vector<Trigger>& triggers() {
    static const std::vector<Trigger> kTriggers = [] {
        std::vector<Trigger> all;
        for (const char* const word : std::get<1>(Schema<command::Adapt>::kFields).type.words) {
            const auto trigger = static_cast<command::Adapt::Trigger>(all.size());
            const AdaptSettings settings = *AdaptSettings{}.with({.trigger = trigger});
            all.push_back({.name = word,
                           .trigger = trigger,
                           .by_tolerance = trigger != command::Adapt::Trigger::normals,
                           .limits_length = settings.drag_limits(1.0, 1.0).l_max < kOff});
        }
        return all;
    }();
    return kTriggers;
}

AdaptSettings settings_of(const Trigger& trigger, const Case& of, double detail) {
    command::Adapt change{.trigger = trigger.trigger};
    (trigger.by_tolerance ? change.tolerance : change.theta_max) =
        Setting::of(trigger.by_tolerance ? detail * of.diagonal() : detail);
    Result<AdaptSettings> settings = AdaptSettings{}.with(change);
    if (!settings) throw std::runtime_error(settings.refusal().reason);
    return *settings;
}

AdaptLimits limits_of(const AdaptSettings& settings, const Case& of) {
    AdaptLimits limits = settings.drag_limits(of.warp.smallest_feature_extent(), of.diagonal(),
                                              of.largest_coordinate());
    limits.budget = of.mesh.face_count() + kMostFaces;
    return limits;
}

std::vector<Method> methods() {
    std::vector<Method> all;
    all.push_back({.name = "uniform",
                   .parameter = "rounds",
                   .details = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12},
                   .refine = [](const Case&, Scene& scene, double rounds) {
                       return subdivide(scene, static_cast<int>(rounds));
                   }});
    all.push_back(printed_method(Order::longest_first));
    all.push_back(printed_method(Order::first_come));
    for (const Trigger& trigger : triggers()) {
        if (trigger.limits_length) all.push_back(product_method(trigger, true));
        all.push_back(product_method(trigger, false));
    }
    return all;
}

}  // namespace pectin::study
