// The cubic B-spline basis in value, power and Bernstein form.
#include "ffd/cubic_basis.h"

#include <gtest/gtest.h>

#include <random>

namespace pectin {
namespace {

TEST(Basis, IsAPartitionOfUnity) {
    std::mt19937 random{1};
    SCOPED_TRACE("seed 1");
    std::uniform_real_distribution<double> parameter{-9.0, 9.0};
    for (int trial = 0; trial < 1000; ++trial) {
        const double u = parameter(random);
        double values = 0.0, derivatives = 0.0;
        for (int i = -12; i <= 12; ++i) {
            values += basis(u - i);
            derivatives += basis_derivative(u - i);
        }
        EXPECT_NEAR(values, 1.0, 1e-15);
        EXPECT_NEAR(derivatives, 0.0, 1e-15);
    }
}

TEST(Basis, ReproducesTheParameterByLinearPrecision) {
    for (double u = -3.0; u <= 3.0; u += 0.0625) {
        double sum = 0.0;
        for (int i = -6; i <= 6; ++i) sum += basis(u - i) * i;
        EXPECT_NEAR(sum, u, 1e-14);
    }
}

TEST(Basis, IsExactlyZeroFromTheEndsOfItsSupportOn) {
    for (const double s : {-1e300, -5.0, -2.0, 2.0, 2.5, 1e300}) {
        EXPECT_EQ(basis(s), 0.0);
        EXPECT_EQ(basis_derivative(s), 0.0);
    }
    EXPECT_GT(basis(1.999), 0.0);
    EXPECT_GT(basis(-1.999), 0.0);
}

TEST(Basis, HasTheKnownValuesAtItsKnots) {
    EXPECT_DOUBLE_EQ(basis(0.0), 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(basis(1.0), 1.0 / 6.0);
    EXPECT_DOUBLE_EQ(basis(-1.0), 1.0 / 6.0);
    EXPECT_DOUBLE_EQ(basis_derivative(1.0), -0.5);
    EXPECT_DOUBLE_EQ(basis_derivative(-1.0), 0.5);
    EXPECT_EQ(basis_derivative(0.0), 0.0);
}

// One-sided differences from either side of each knot agree up to the jump of the third derivative.
TEST(Basis, HasTwoContinuousDerivativesAtEveryKnot) {
    const double h = 1e-3;
    for (const double knot : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
        const auto second = [&](double side) {
            return (basis(knot) - 2.0 * basis(knot + side * h) + basis(knot + 2.0 * side * h)) /
                   (h * h);
        };
        EXPECT_NEAR(basis(knot - 1e-9), basis(knot + 1e-9), 1e-8);
        EXPECT_NEAR(basis_derivative(knot - 1e-9), basis_derivative(knot + 1e-9), 1e-8);
        EXPECT_NEAR(second(-1.0), second(1.0), 8.0 * h);
    }
}

TEST(Basis, DerivativeMatchesCentralDifferences) {
    const double h = 1e-5;
    for (double s = -2.2; s < 2.2; s += 0.013) {
        const double difference = (basis(s + h) - basis(s - h)) / (2.0 * h);
        EXPECT_NEAR(basis_derivative(s), difference, 1e-9);
    }
}

TEST(BasisSpan, HoldsTheFourControlPointsThatReachAParameter) {
    std::mt19937 random{2};
    SCOPED_TRACE("seed 2");
    std::uniform_real_distribution<double> parameter{-9.0, 9.0};
    for (int trial = 0; trial < 1000; ++trial) {
        const double u = trial < 19 ? trial - 9.0 : parameter(random);
        const BasisSpan span = basis_span(u);
        for (int i = -12; i <= 12; ++i) {
            const auto k = static_cast<std::size_t>(i - span.first);
            EXPECT_NEAR(k < 4 ? span.value[k] : 0.0, basis(u - i), 1e-15);
            EXPECT_NEAR(k < 4 ? span.derivative[k] : 0.0, basis_derivative(u - i), 1e-15);
        }
    }
}

TEST(BasisSpan, EqualsThePowerFormInsideACell) {
    for (double t = 0.0; t < 1.0; t += 0.03125) {
        const BasisSpan span = basis_span(t);
        for (std::size_t k = 0; k < 4; ++k) {
            const CubicCoefficients& p = kPowerSegments[k];
            EXPECT_NEAR(span.value[k], ((p[3] * t + p[2]) * t + p[1]) * t + p[0], 1e-15);
            EXPECT_NEAR(span.derivative[k], (3.0 * p[3] * t + 2.0 * p[2]) * t + p[1], 1e-15);
        }
    }
}

TEST(BernsteinSegments, SumToOneAndAreTheConversionOfTheWholeCell) {
    const CubicSegments whole = bernstein_conversion(0.0, 1.0);
    for (std::size_t i = 0; i < 4; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            sum += kBernsteinSegments[k][i];
            EXPECT_NEAR(whole[i][k], kBernsteinSegments[k][i], 1e-15);
        }
        EXPECT_NEAR(sum, 1.0, 1e-15);
    }
}

}  // namespace
}  // namespace pectin
