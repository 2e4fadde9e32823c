// The paper's figure 7: an extrusion and a flattening of a low-resolution object, with and without
// adaptive meshing. The pictures come from the same scripts, by `pectin replay`.
//
// Source: J. Gain, N. Dodgson. Adaptive Refinement and Decimation under Free-Form Deformation.
// Eurographics UK 1999. Section 5 and figure 7.
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "adapt/defaults.h"
#include "command/script.h"
#include "session/session.h"
#include "study/cases.h"
#include "study/printed_rules.h"
#include "study/scene.h"
#include "study/studies.h"

namespace pectin::study {
namespace {

// Far more repetitions than elsewhere, since a drag takes less than a millisecond.
constexpr std::size_t kRuns = 101;

std::vector<Command> commands_of(const std::string& name) {
    std::ifstream text(std::string(PECTIN_SOURCE_DIR) + "/tests/study/" + name);
    ScriptReader reader(text);
    std::vector<Command> commands;
    while (std::optional<ScriptLine> line = reader.next()) {
        if (!std::holds_alternative<Command>(line->command)) {
            throw std::runtime_error(name + " has an invalid line");
        }
        commands.push_back(std::get<Command>(line->command));
    }
    return commands;
}

// What one drag of the script has done in each run.
struct Measured {
    Statistics::Last last;  // of the last run
    std::uint64_t faces = 0;
    std::vector<double> whole, deform, refine, decimate;  // seconds
};

// Runs the script without its pictures. The times are those of `stats`; the whole is that of the
// drag from press to release, including the undo step.
std::vector<Measured> run_script(const std::string& name) {
    const std::vector<Command> commands = commands_of(name);
    std::vector<Measured> drags;
    for (std::size_t run = 0; run < kRuns; ++run) {
        Session session;
        std::size_t drag = 0;
        for (const Command& command : commands) {
            if (std::holds_alternative<command::Screenshot>(command)) continue;
            if (std::holds_alternative<command::Drag>(command)) session.prepare_for_drags();
            const double time = seconds([&] {
                const Done done = session.execute(command);
                if (!done) throw std::runtime_error(done.refusal().reason);
            });
            if (!std::holds_alternative<command::Drag>(command)) continue;
            if (drag == drags.size()) drags.emplace_back();
            Measured& to = drags[drag++];
            const Statistics statistics = session.statistics();
            to.last = statistics.last;
            to.faces = statistics.faces;
            to.whole.push_back(time);
            to.deform.push_back(statistics.last.seconds.deform);
            to.refine.push_back(statistics.last.seconds.refine);
            to.decimate.push_back(statistics.last.seconds.decimate);
        }
    }
    return drags;
}

Json as_json(const std::string& what, const std::string& picture, const Measured& m) {
    return {{"what", what},
            {"picture", picture},
            {"refinements", m.last.splits},
            {"decimations", m.last.unsplits},
            {"faces", m.faces},
            {"whole", median(m.whole)},
            {"deform", median(m.deform)},
            {"refine", median(m.refine)},
            {"decimate", median(m.decimate)}};
}

// The drags of extrusion.jsonl by the rules as the paper prints them.
Json by_print() {
    Json result = Json::array();
    TriMesh mesh = shape(ShapeKind::sphere, 2);
    double radius = 0.0;
    int span = 0;
    for (const Command& command : commands_of("extrusion.jsonl")) {
        if (const auto* const brush = std::get_if<command::Brush>(&command)) {
            radius = brush->radius.value_or(radius);
            span = brush->span.value_or(span);
        }
        const auto* const drag = std::get_if<command::Drag>(&command);
        if (!drag) continue;
        const Warp warp = brush_drag(drag->moves.front(), radius, span);
        const PrintedRules rules{
            .curvature = NormalDivergence(
                {.theta_max = kDefaultThetaMax, .theta_min = default_theta_min(kDefaultThetaMax)}),
            .l_max = default_l_max(warp.smallest_feature_extent())};
        Scene scene(mesh, warp);
        const PrintedRefinement refined = refine_as_printed(scene, rules);
        const std::uint64_t removed = decimate_as_printed(scene, rules);
        mesh = scene.finish();
        result.push_back({{"refinements", refined.splits},
                          {"has_ended", refined.has_ended},
                          {"decimations", removed},
                          {"faces", mesh.face_count()}});
    }
    return result;
}

}  // namespace

Json study_extrusion(const Options&) {
    const std::vector<Measured> adaptive = run_script("extrusion.jsonl");
    const std::vector<Measured> plain = run_script("extrusion_plain.jsonl");
    return {{"runs", kRuns},
            {"faces_at_rest", shape(ShapeKind::sphere, 2).face_count()},
            {"drags",
             {as_json("extrusion, adaptive", "b", adaptive[0]),
              as_json("extrusion, without adaptivity", "c", plain[0]),
              as_json("flattening, adaptive", "d", adaptive[1]),
              as_json("flattening, without adaptivity", "e", plain[2])}},
            {"by_print", by_print()}};
}

}  // namespace pectin::study
