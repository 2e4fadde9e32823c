#include "geometry/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace pectin {
namespace {

// An exact sum of doubles, as components of increasing size that do not overlap.
class ExactSum {
  public:
    // Adds x * y (Shewchuk 1997, sections 2.4 and 2.5).
    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    int sign() const {
        for (std::size_t i = size_; i-- > 0;) {
            if (parts_[i] != 0.0) return parts_[i] > 0.0 ? 1 : -1;
        }
        return 0;
    }

  private:
    void add(double value) {
        for (std::size_t i = 0; i < size_; ++i) {
            const double part = parts_[i], sum = value + part;
            const double rounded = sum - value;
            parts_[i] = (value - (sum - rounded)) + (part - rounded);
            value = sum;
        }
        parts_[size_++] = value;
    }

    std::array<double, 24> parts_{};
    std::size_t size_ = 0;
};

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    // Shewchuk 1997, section 4.1: (3 + 16 u) u with u = 2^-53.
    constexpr double kErrorBound = 3.3306690738754716e-16;
    const double determinant = left - right;
    if (std::abs(determinant) > kErrorBound * (std::abs(left) + std::abs(right))) {
        return determinant > 0.0 ? 1 : -1;
    }
    ExactSum sum;
    sum.add_product(a.x, b.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-c.x, b.y);
    sum.add_product(-a.y, b.x);
    sum.add_product(a.y, c.x);
    sum.add_product(c.y, b.x);
    return sum.sign();
}

int orientation(const MovingPoint& a, const MovingPoint& b, const MovingPoint& c) {
    // The determinant is a polynomial in time; the first coefficient that is not 0 decides.
    if (const int constant = orientation(a.at, b.at, c.at)) return constant;
    ExactSum linear;
    const auto add = [&](const MovingPoint& p, const MovingPoint& q) {
        linear.add_product(p.at.x, q.velocity.y);
        linear.add_product(p.velocity.x, q.at.y);
        linear.add_product(-p.at.y, q.velocity.x);
        linear.add_product(-p.velocity.y, q.at.x);
    };
    add(a, b);
    add(b, c);
    add(c, a);
    if (const int sign = linear.sign()) return sign;
    return orientation(a.velocity, b.velocity, c.velocity);
}

}  // namespace pectin
