// Success or failure of what a user asks for, as a value.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace pectin {

// Why something was not done: what is wrong and what would be right, in one line for the user.
struct Refusal {
    std::string reason;
    // The field of the command that the reason is about, such as "moves[0].to"; empty if it is
    // about none or about several.
    std::string field{};
    // A word for what is wrong, such as "pinned", for callers that have words of their own for it;
    // empty if there is none.
    std::string kind{};

    bool operator==(const Refusal&) const = default;
};

// The value, or the reason why there is none. Converts to true on success.
template <typename Value>
class [[nodiscard]] Result {
  public:
    Result(Value value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Refusal refusal) : state_(std::in_place_index<1>, std::move(refusal)) {}

    explicit operator bool() const { return state_.index() == 0; }
    // Preconditions: success for the first four, failure for the last.
    Value& operator*() { return std::get<0>(state_); }
    const Value& operator*() const { return std::get<0>(state_); }
    Value* operator->() { return &std::get<0>(state_); }
    const Value* operator->() const { return &std::get<0>(state_); }
    const Refusal& refusal() const { return std::get<1>(state_); }

  private:
    std::variant<Value, Refusal> state_;
};

// The result of something that is done or refused, and has no value. Done{} is success.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Refusal refusal) : state_(std::move(refusal)) {}

    explicit operator bool() const { return state_.index() == 0; }
    const Refusal& refusal() const { return std::get<1>(state_); }  // precondition: failure

  private:
    std::variant<std::monostate, Refusal> state_;
};

using Done = Result<void>;

}  // namespace pectin
