// A number that counts the arithmetic done with it, for the paper's figure 5.
#pragma once

#include <cmath>
#include <cstdint>

namespace pectin::study {

// As the paper counts them: additions and subtractions are the same, comparisons, absolute values,
// changes of sign and integer parts count as nothing.
struct Operations {
    std::uint64_t additions = 0, multiplications = 0, divisions = 0, square_roots = 0;

    // The cost by the paper's weights, in additions on its machine (figure 5, note 3).
    double cost() const {
        return static_cast<double>(additions) + 1.07 * static_cast<double>(multiplications) +
               1.91 * static_cast<double>(divisions) + 1.88 * static_cast<double>(square_roots);
    }
};

class Counted {
  public:
    Counted(double value = 0.0) : value_(value) {}

    double value() const { return value_; }
    // The operations since the last call.
    static Operations take() {
        const Operations taken = operations;
        operations = {};
        return taken;
    }

    friend Counted operator+(Counted a, Counted b) {
        ++operations.additions;
        return a.value_ + b.value_;
    }
    friend Counted operator-(Counted a, Counted b) {
        ++operations.additions;
        return a.value_ - b.value_;
    }
    friend Counted operator*(Counted a, Counted b) {
        ++operations.multiplications;
        return a.value_ * b.value_;
    }
    friend Counted operator/(Counted a, Counted b) {
        ++operations.divisions;
        return a.value_ / b.value_;
    }
    friend bool operator<(Counted a, Counted b) { return a.value_ < b.value_; }
    friend Counted sqrt(Counted a) {
        ++operations.square_roots;
        return std::sqrt(a.value_);
    }
    friend Counted abs(Counted a) { return std::abs(a.value_); }
    friend double floor(Counted a) { return std::floor(a.value_); }

  private:
    inline static Operations operations;
    double value_;
};

}  // namespace pectin::study
