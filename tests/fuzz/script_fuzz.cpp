// Reads arbitrary bytes as a script and executes its commands on a small mesh. The mesh must stay
// valid and undo must restore it. Commands that access files are only parsed.
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

#include "command/json.h"
#include "command/script.h"
#include "fuzz/expect.h"
#include "io/obj_writer.h"
#include "session/session.h"

namespace {

using namespace pectin;
using fuzz::expect;

// Limits with which one input takes milliseconds.
constexpr int kMaxCommands = 12;
constexpr int kMaxResolution = 3;
constexpr std::uint64_t kBudget = 1500;  // triangles
constexpr std::int64_t kMaxControlPoints = 1000;
constexpr std::size_t kMaxPoints = 16;

bool is_small(const command::Shape& shape) { return shape.resolution <= kMaxResolution; }
bool is_small(const command::Brush& brush) { return brush.span.value_or(0) <= 8; }
bool is_small(const command::Cage& cage) {
    const IVec3 n = cage.fit.value_or(cage.deformable.value_or(IVec3{1}));
    return std::int64_t{n.x} * n.y * n.z <= kMaxControlPoints;
}
bool is_small(const command::Drag& drag) {
    return drag.moves.size() + drag.pins.size() <= kMaxPoints;
}
template <typename Any>
bool is_small(const Any&) {
    return !requires(Any c) { c.path; };  // commands with a path are not executed
}

void expect_same_when_read_back(const Command& command) {
    const auto again = parse_command(format_command(command));
    expect(std::holds_alternative<Command>(again) && std::get<Command>(again) == command,
           "a command is the same when written and read back: " + format_command(command));
}

void expect_valid(const Session& session) {
    const std::vector<std::string> violations = session.mesh().validate();
    expect(violations.empty(), "the mesh is valid: " + (violations.empty() ? "" : violations[0]));
}

// A session and its object before the first step.
class SmallSession {
  public:
    SmallSession() { execute(command::Shape{command::Shape::Kind::sphere, 1}); }

    void execute(Command command) {
        if (auto* adapt = std::get_if<command::Adapt>(&command)) {
            adapt->budget = std::min(adapt->budget.value_or(kBudget), kBudget);
        }
        const std::string before = format_obj(session_.mesh());
        const Done done = session_.execute(command);
        expect_valid(session_);
        if (!done) {
            const std::string& reason = done.refusal().reason;
            expect(!reason.empty() && reason.find('\n') == reason.npos, "a refusal is one line");
            expect(format_obj(session_.mesh()) == before, "a refusal leaves the object as it was");
        } else if (std::holds_alternative<command::Shape>(command)) {
            first_ = format_obj(session_.mesh());
            expect(bool{session_.execute(command::Adapt{.budget = kBudget})}, "the budget is set");
        }
    }

    void undo_all() {
        const auto count = static_cast<int>(session_.undo_count());
        if (count > 0) execute(command::Undo{count});
        if (session_.history().lost_undo_count() > 0) return;
        expect(format_obj(session_.mesh()) == first_, "undo gives back what there was");
    }

  private:
    Session session_;
    std::string first_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
    ScriptReader reader(text);
    std::optional<SmallSession> session;
    for (int i = 0; i < kMaxCommands; ++i) {
        const auto line = reader.next();
        if (!line) break;
        const auto* command = std::get_if<Command>(&line->command);
        if (!command) break;
        expect_same_when_read_back(*command);
        if (!std::visit([](const auto& c) { return is_small(c); }, *command)) continue;
        if (!session) session.emplace();
        session->execute(*command);
    }
    if (session) session->undo_all();
    return 0;
}
