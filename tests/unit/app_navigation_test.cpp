// Navigation: what orbits, pans, zooms and views do to the camera, with random cameras around
// objects of all sizes.
#include "app/navigation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "support/random_mesh.h"
#include "support/test_run.h"

namespace pectin {
namespace {

using test::Random;

constexpr IVec2 kSize{1200, 800};
constexpr PictureArea kWhole{.min = {-1.5, -1.0}, .max = {1.5, 1.0}};
constexpr double kPixels = 1e-3;  // tolerance

// Spheres, for which everything that navigation asks has a simple answer.
class Spheres final : public NavigatedObject {
  public:
    struct Sphere {
        Vec3 centre{0.0};
        double radius = 1.0;
    };
    explicit Spheres(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {}

    std::optional<Vec3> first_hit(const Ray& ray) override {
        double first = std::numeric_limits<double>::infinity();
        for (const Sphere& sphere : spheres_) {
            const Vec3 to = sphere.centre - ray.origin;
            const double along = glm::dot(to, ray.direction);
            const Vec3 nearest = to - along * ray.direction;
            const double square = sphere.radius * sphere.radius - glm::dot(nearest, nearest);
            if (square < 0.0) continue;
            for (const double t : {along - std::sqrt(square), along + std::sqrt(square)}) {
                if (t >= 0.0) first = std::min(first, t);
            }
        }
        if (std::isinf(first)) return std::nullopt;
        return ray.at(first);
    }
    double distance(const Vec3& point) override {
        double least = std::numeric_limits<double>::infinity();
        for (const Sphere& sphere : spheres_) {
            least = std::min(least, std::abs(glm::distance(point, sphere.centre) - sphere.radius));
        }
        return least;
    }
    double diagonal() const override {
        Box box;
        for (const Sphere& sphere : spheres_) {
            box.include(sphere.centre - sphere.radius);
            box.include(sphere.centre + sphere.radius);
        }
        return box.diagonal();
    }
    bool contains(const Vec3& point) const {
        return std::ranges::any_of(spheres_, [&](const Sphere& sphere) {
            return glm::distance(point, sphere.centre) < sphere.radius;
        });
    }
    // Points of the surfaces.
    std::vector<Vec3> points() const {
        std::vector<Vec3> all;
        Random random(1);
        for (const Sphere& sphere : spheres_) {
            for (int i = 0; i < 60; ++i) {
                all.push_back(sphere.centre + sphere.radius * random.direction());
            }
        }
        return all;
    }
    const std::vector<Sphere>& spheres() const { return spheres_; }

  private:
    std::vector<Sphere> spheres_;
};

// A head with two ears.
Spheres head(double scale = 1.0, const Vec3& at = Vec3(0.0)) {
    return Spheres({{at, scale},
                    {at + scale * Vec3(1.15, 0.2, 0.0), 0.3 * scale},
                    {at + scale * Vec3(-1.15, 0.2, 0.0), 0.3 * scale}});
}

void expect_pixel(const Camera& camera, const Vec3& point, const Vec2& pixel) {
    const auto seen = camera.project(point, kSize);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, pixel.x, kPixels);
    EXPECT_NEAR(seen->y, pixel.y, kPixels);
}

// Calls test(random, navigation, object) for objects of all scales and framed views of them.
template <typename Test>
void for_random_views(std::uint64_t first_seed, int count, const Test& test) {
    const int cases = test::case_count(count);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double scale = random.scale(1e-3, 1e6);
        Spheres object = head(scale, 3.0 * scale * random.direction());
        Navigation navigation(object);
        if (random.chance(0.5)) navigation.set_up_axis(UpAxis::z, kSize);
        if (random.chance(0.3)) navigation.set_projection(Projection::orthographic, kSize);
        navigation.frame(object.points(), kWhole, random.direction());
        test(random, navigation, object);
        if (testing::Test::HasFailure()) return;
    }
}

Vec2 random_pixel(Random& random) {
    return {random.uniform(0.0, kSize.x), random.uniform(0.0, kSize.y)};
}

// --- Orbits.

TEST(Navigation, OrbitKeepsThePixelOfThePointUnderTheCursorAtThePress) {
    for_random_views(1, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const auto hit = object.first_hit(navigation.camera().ray_through(pixel, kSize));
        if (!hit) return;
        const Camera before = navigation.camera();
        navigation.begin(NavigationMode::orbit, MouseButton::middle, pixel, kSize);
        EXPECT_EQ(navigation.camera(), before) << "the picture jumps";
        for (int i = 0; i < 10; ++i) {
            navigation.move_to(random_pixel(random), kSize);
            expect_pixel(navigation.camera(), *hit, pixel);
            EXPECT_NEAR(navigation.camera().distance() / before.distance(), 1.0, 1e-6);
        }
    });
}

TEST(Navigation, OrbitBesideTheObjectKeepsThePixelOfThePointThatWasTouchedLast) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    const Vec3 nose{0.3, 0.1, 0.94};
    navigation.touch(nose);
    const Vec2 pixel = *navigation.camera().project(nose, kSize);
    navigation.begin(NavigationMode::orbit, MouseButton::left, {20, 20}, kSize);
    navigation.move_to({220, 130}, kSize);
    expect_pixel(navigation.camera(), nose, pixel);
}

TEST(Navigation, OrbitTurnsAboutTheTargetWhereTheTouchedPointIsNotInTheWindow) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    navigation.touch({100.0, 0.0, 0.0});
    const Vec3 target = navigation.camera().target;
    navigation.begin(NavigationMode::orbit, MouseButton::left, {20, 20}, kSize);
    navigation.move_to({220, 130}, kSize);
    EXPECT_NEAR(glm::distance(navigation.camera().target, target), 0.0, 1e-12);
}

TEST(Navigation, OrbitReturnsWithTheCursor) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    const Camera before = navigation.camera();
    navigation.begin(NavigationMode::orbit, MouseButton::left, {100, 100}, kSize);
    navigation.move_to({160, 70}, kSize);
    EXPECT_GT(glm::distance(navigation.camera().eye, before.eye), 0.1);
    navigation.move_to({100, 100}, kSize);
    EXPECT_NEAR(glm::distance(navigation.camera().eye, before.eye), 0.0, 1e-12);
}

TEST(Navigation, TurnsMoveTheEyeToTheRightAndUpwards) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    navigation.turn(0.5 * std::numbers::pi, 0.0, kSize);
    EXPECT_NEAR(glm::distance(navigation.camera().forward(), Vec3(-1, 0, 0)), 0.0, 1e-9);
    navigation.turn(0.0, 0.25 * std::numbers::pi, kSize);
    EXPECT_LT(navigation.camera().forward().y, -0.7);
}

// --- Pans.

TEST(Navigation, PanKeepsThePointUnderTheCursorThere) {
    for_random_views(1000, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const auto hit = object.first_hit(navigation.camera().ray_through(pixel, kSize));
        if (!hit) return;
        navigation.begin(NavigationMode::pan, MouseButton::middle, pixel, kSize);
        for (int i = 0; i < 5; ++i) {
            const Vec2 at = random_pixel(random);
            navigation.move_to(at, kSize);
            expect_pixel(navigation.camera(), *hit, at);
        }
    });
}

// --- Zooms.

TEST(Navigation, ZoomKeepsThePixelOfThePointUnderTheCursor) {
    for_random_views(2000, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const auto hit = object.first_hit(navigation.camera().ray_through(pixel, kSize));
        if (!hit) return;
        for (int i = 0; i < 20; ++i) {
            // Notches of a wheel, and fractions of them.
            navigation.zoom(random.uniform(-0.5, 1.5), pixel, kSize);
            expect_pixel(navigation.camera(), *hit, pixel);
        }
        navigation.begin(NavigationMode::zoom, MouseButton::middle, pixel, kSize);
        for (int i = 0; i < 10; ++i) {
            navigation.move_to(random_pixel(random), kSize);
            expect_pixel(navigation.camera(), *hit, pixel);
        }
    });
}

TEST(Navigation, ZoomNeverTakesTheEyeThroughTheSurfaceOrNearerThanTheClosestDistance) {
    for_random_views(3000, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        if (navigation.camera().is_orthographic()) return;
        const double closest = kClosest * object.diagonal();
        for (int i = 0; i < 60; ++i) {
            const Vec2 pixel = random_pixel(random);
            if (random.chance(0.3)) {
                navigation.begin(NavigationMode::zoom, MouseButton::middle, pixel, kSize);
                navigation.move_to(pixel - Vec2(0.0, random.uniform(0.0, 3000.0)), kSize);
                navigation.end();
            } else {
                navigation.zoom(random.uniform(0.0, 12.0), pixel, kSize);
            }
            ASSERT_TRUE(navigation.camera().is_valid());
            ASSERT_FALSE(object.contains(navigation.camera().eye)) << "after " << i << " zooms";
            ASSERT_GE(object.distance(navigation.camera().eye), 0.999 * closest);
        }
    });
}

TEST(Navigation, TheNearPlaneCutsNothingOffAfterZoomingIn) {
    for_random_views(4000, 200, [](Random& random, Navigation& navigation, Spheres& object) {
        if (navigation.camera().is_orthographic()) return;
        for (int i = 0; i < 30; ++i) navigation.zoom(4.0, random_pixel(random), kSize);
        Box box;
        for (const auto& sphere : object.spheres()) {
            box.include(sphere.centre - sphere.radius);
            box.include(sphere.centre + sphere.radius);
        }
        const Camera& camera = navigation.camera();
        const DepthRange depths = depth_range(camera, box);
        for (int i = 0; i < 500; ++i) {
            const Vec2 pixel = random_pixel(random);
            const auto hit = object.first_hit(camera.ray_through(pixel, kSize));
            if (!hit) continue;
            // The renderer halves the near distance.
            EXPECT_GT(camera.depth(*hit), 0.5 * depths.near);
            EXPECT_LT(camera.depth(*hit), depths.far);
        }
    });
}

TEST(Navigation, ZoomBesideTheObjectMovesAlongTheRayOfTheCursorAndEndsBeforeEmptySpace) {
    for_random_views(5000, 200, [](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const Ray ray = navigation.camera().ray_through(pixel, kSize);
        if (object.first_hit(ray) || navigation.camera().is_orthographic()) return;
        const double before = navigation.camera().distance();
        for (int i = 0; i < 200; ++i) {
            const double last = navigation.camera().distance();
            navigation.zoom(1.0, pixel, kSize);
            EXPECT_LE(navigation.camera().distance(), last * (1.0 + 1e-9));
            EXPECT_GE(navigation.camera().distance(), 0.85 * last) << "jumps";
            const Vec3 moved = navigation.camera().eye - ray.origin;
            EXPECT_NEAR(glm::length(glm::cross(moved, ray.direction)) / before, 0.0, 1e-6);
        }
        EXPECT_LT(navigation.camera().distance(), 0.9 * before);
        EXPECT_GE(navigation.camera().distance(),
                  0.499 * std::min(object.distance(navigation.camera().eye), object.diagonal()));
    });
}

TEST(Navigation, ZoomReachesTheClosestDistanceInOneWayAtAllScales) {
    for_random_views(6000, 100, [](Random&, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = *navigation.camera().project(object.spheres()[0].centre, kSize);
        int notches = 0;
        double last = 0.0;
        while (navigation.camera().distance() != last && notches < 200) {
            last = navigation.camera().distance();
            navigation.zoom(1.0, pixel, kSize);
            ++notches;
        }
        EXPECT_LT(notches, 90);
        EXPECT_LT(navigation.camera().distance(), 2.0 * kClosest * object.diagonal());
        notches = 0;
        for (last = 0.0; navigation.camera().distance() != last && notches < 400; ++notches) {
            last = navigation.camera().distance();
            navigation.zoom(-1.0, pixel, kSize);
        }
        EXPECT_LT(notches, 200);
        EXPECT_LE(navigation.camera().distance(), 1.001 * kFarthest * object.diagonal());
        EXPECT_TRUE(navigation.camera().is_valid());
    });
}

TEST(Navigation, ManySmallAmountsZoomAsOneNotchDoes) {
    Spheres object = head();
    Navigation one(object), many(object);
    for (Navigation* navigation : {&one, &many}) {
        navigation->frame(object.points(), kWhole, kFrontView);
    }
    one.zoom(1.0, {600, 400}, kSize);
    for (int i = 0; i < 20; ++i) many.zoom(0.05, {600, 400}, kSize);
    EXPECT_NEAR(glm::distance(one.camera().eye, many.camera().eye), 0.0, 1e-12);
}

TEST(Navigation, ZoomingInTouchesThePointThatOrbitsThenTurnAbout) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    const Vec2 pixel{700, 300};
    const Vec3 hit = *object.first_hit(navigation.camera().ray_through(pixel, kSize));
    for (int i = 0; i < 5; ++i) navigation.zoom(1.0, pixel, kSize);
    navigation.turn(0.4, 0.2, kSize);
    expect_pixel(navigation.camera(), hit, pixel);
}

// --- The surface in the way.

TEST(Navigation, NeitherOrbitsNorPansNorTurnsTakeTheEyeThroughTheSurface) {
    int stopped = 0;
    for_random_views(7500, 300, [&](Random& random, Navigation& navigation, Spheres& object) {
        navigation.set_projection(Projection::perspective, kSize);
        for (int i = 0; i < 12; ++i) {
            navigation.zoom(random.uniform(0.0, 12.0), random_pixel(random), kSize);
            const Vec2 from = random_pixel(random), to = random_pixel(random);
            const double before = object.distance(navigation.camera().eye);
            switch (random.integer(0, 3)) {
                case 0:
                    navigation.begin(NavigationMode::orbit, MouseButton::middle, from, kSize);
                    navigation.move_to(to, kSize);
                    break;
                case 1:
                    navigation.begin(NavigationMode::pan, MouseButton::middle, from, kSize);
                    navigation.move_to(to, kSize);
                    break;
                case 2:
                    navigation.pan(20.0 * (to - from), kSize);
                    break;
                default:
                    navigation.turn(random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0), kSize);
            }
            navigation.end();
            const Vec3 eye = navigation.camera().eye;
            ASSERT_FALSE(object.contains(eye));
            const double least = kTurnClearance * kClosest * object.diagonal();
            ASSERT_GE(object.distance(eye), std::min(before, (1.0 - 1e-6) * least));
            stopped += object.distance(eye) < 1.01 * least ? 1 : 0;
        }
    });
    EXPECT_GT(stopped, test::case_count(300) / 10) << "the surface was seldom in the way";
}

TEST(Navigation, AnOrbitEndsAtTheSurfaceAndGoesBackWithTheCursor) {
    Spheres object({{Vec3(0.0), 1.0}, {Vec3(3.0, 0.0, 0.0), 1.0}});
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    navigation.touch(Vec3(0.0, 0.0, 1.0));
    navigation.zoom(6.0, *navigation.camera().project(Vec3(0.0, 0.0, 1.0), kSize), kSize);
    const Camera before = navigation.camera();
    navigation.begin(NavigationMode::orbit, MouseButton::middle, {600, 400}, kSize);
    const Vec3 pivot{0.0, 0.0, 1.0};
    ASSERT_GT(glm::distance(before.eye, pivot), 0.2);
    for (int x = 600; x >= 0; x -= 10) {
        navigation.move_to({x, 400}, kSize);
        ASSERT_FALSE(object.contains(navigation.camera().eye)) << x;
    }
    const double angle =
        std::acos(std::clamp(glm::dot(navigation.camera().forward(), before.forward()), -1.0, 1.0));
    EXPECT_GT(angle, 1.0) << "it went on to the surface";
    EXPECT_LT(angle, 2.2) << "and ended there";
    navigation.move_to({10, 400}, kSize);
    EXPECT_GT(glm::dot(navigation.camera().forward(), before.forward()), std::cos(angle));
}

TEST(Navigation, OrthographicViewsAreNotStopped) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.set_projection(Projection::orthographic, kSize);
    navigation.frame(object.points(), kWhole, kFrontView);
    navigation.zoom(10.0, 0.5 * Vec2(kSize), kSize);
    navigation.turn(2.5, 0.0, kSize);
    EXPECT_NEAR(navigation.camera().forward().z, -std::cos(2.5), 1e-9);
}

TEST(Navigation, TheClosestViewCanBeTurnedByHalfARightAngle) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFrontView);
    for (int i = 0; i < 200; ++i) navigation.zoom(1.0, 0.5 * Vec2(kSize), kSize);
    const Vec3 before = navigation.camera().forward();
    navigation.turn(0.75, 0.0, kSize);
    EXPECT_NEAR(glm::dot(navigation.camera().forward(), before), std::cos(0.75), 1e-3);
}

// --- Projections.

TEST(Navigation, TheSurfaceInTheMiddleKeepsItsSizeWhenTheProjectionChanges) {
    for_random_views(7000, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        navigation.zoom(random.uniform(-2.0, 9.0), random_pixel(random), kSize);
        const Ray ray = navigation.camera().ray_through(0.5 * Vec2(kSize), kSize);
        const auto hit = object.first_hit(ray);
        const Camera before = navigation.camera();
        navigation.set_projection(
            before.is_orthographic() ? Projection::perspective : Projection::orthographic, kSize);
        if (!hit) return;
        expect_pixel(navigation.camera(), *hit, 0.5 * Vec2(kSize));
        EXPECT_NEAR(
            navigation.camera().pixel_length(*hit, kSize) / before.pixel_length(*hit, kSize), 1.0,
            1e-6);
    });
}

TEST(Navigation, LeavingTheOrthographicProjectionLeavesTheEyeOutsideTheObject) {
    for_random_views(8000, 300, [](Random& random, Navigation& navigation, Spheres& object) {
        navigation.set_projection(Projection::orthographic, kSize);
        for (int i = 0; i < 5; ++i) {
            navigation.zoom(random.uniform(-2.0, 9.0), random_pixel(random), kSize);
            navigation.turn(random.uniform(-1.0, 1.0), random.uniform(-0.5, 0.5), kSize);
        }
        navigation.set_projection(Projection::perspective, kSize);
        EXPECT_FALSE(object.contains(navigation.camera().eye));
    });
}

// --- Views.

TEST(Navigation, FrameShowsAllPointsWithinTheArea) {
    const PictureArea area{.min = {-0.9, -0.95}, .max = {0.3, 0.7}};
    for_random_views(9000, 200, [&](Random& random, Navigation& navigation, Spheres& object) {
        const std::vector<Vec3> points = object.points();
        navigation.frame(points, area, random.direction());
        EXPECT_TRUE(navigation.is_as_framed());
        for (const Vec3& point : points) {
            const auto seen = navigation.camera().project(point, kSize);
            ASSERT_TRUE(seen);
            EXPECT_TRUE(600 - 0.9 * 400 <= seen->x && seen->x <= 600 + 0.3 * 400) << seen->x;
            EXPECT_TRUE(400 - 0.7 * 400 <= seen->y && seen->y <= 400 + 0.95 * 400) << seen->y;
        }
    });
}

TEST(Navigation, ViewsLookAlongTheAxesWithTheModelUpright) {
    struct Case {
        UpAxis up;
        Vec3 direction, from, picture_up;
    };
    const std::vector<Case> cases{
        {UpAxis::y, kFrontView, {0, 0, 1}, {0, 1, 0}},
        {UpAxis::y, kBackView, {0, 0, -1}, {0, 1, 0}},
        {UpAxis::y, kRightView, {1, 0, 0}, {0, 1, 0}},
        {UpAxis::y, kLeftView, {-1, 0, 0}, {0, 1, 0}},
        {UpAxis::y, kTopView, {0, 1, 0}, {0, 0, -1}},
        {UpAxis::y, kBottomView, {0, -1, 0}, {0, 0, 1}},
        {UpAxis::z, kFrontView, {0, -1, 0}, {0, 0, 1}},
        {UpAxis::z, kBackView, {0, 1, 0}, {0, 0, 1}},
        {UpAxis::z, kRightView, {1, 0, 0}, {0, 0, 1}},
        {UpAxis::z, kLeftView, {-1, 0, 0}, {0, 0, 1}},
        {UpAxis::z, kTopView, {0, 0, 1}, {0, 1, 0}},
        {UpAxis::z, kBottomView, {0, 0, -1}, {0, -1, 0}},
    };
    Spheres object = head();
    for (const Case& c : cases) {
        Navigation navigation(object);
        navigation.set_up_axis(c.up, kSize);
        navigation.frame(object.points(), kWhole, kFitDirection);
        navigation.look_from(c.direction, kSize);
        EXPECT_NEAR(glm::distance(navigation.camera().forward(), -c.from), 0.0, 2e-4);
        EXPECT_NEAR(glm::distance(navigation.camera().true_up(), c.picture_up), 0.0, 2e-4);
        navigation.frame(object.points(), kWhole, c.direction);
        EXPECT_NEAR(glm::distance(navigation.camera().forward(), -c.from), 0.0, 2e-4);
        EXPECT_NEAR(glm::distance(navigation.camera().true_up(), c.picture_up), 0.0, 2e-4);
    }
}

TEST(Navigation, ViewsKeepThePixelOfThePointThatWasTouchedLast) {
    for_random_views(10000, 200, [](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const auto hit = object.first_hit(navigation.camera().ray_through(pixel, kSize));
        if (!hit) return;
        navigation.zoom(3.0, pixel, kSize);
        for (const Vec3& direction : {kRightView, kTopView, kBackView}) {
            navigation.look_from(direction, kSize);
            expect_pixel(navigation.camera(), *hit, pixel);
        }
    });
}

TEST(Navigation, ViewsNeverPutTheEyeIntoTheObject) {
    int moved = 0;
    for_random_views(11000, 200, [&](Random& random, Navigation& navigation, Spheres& object) {
        const Vec2 pixel = random_pixel(random);
        const auto hit = object.first_hit(navigation.camera().ray_through(pixel, kSize));
        if (!hit) return;
        navigation.zoom(random.uniform(1.0, 30.0), pixel, kSize);
        navigation.look_from(kFrontView, kSize);
        const Camera front = navigation.camera();
        const double distance = front.distance();
        for (const Vec3& direction :
             {kBackView, kRightView, kLeftView, kTopView, kBottomView, kFrontView}) {
            navigation.look_from(direction, kSize);
            const Camera& camera = navigation.camera();
            EXPECT_LT(
                glm::distance(glm::normalize(navigation.direction()), glm::normalize(direction)),
                1e-6);
            expect_pixel(camera, *hit, pixel);
            EXPECT_NEAR(camera.distance(), distance, 1e-6 * distance) << "the scale stays";
            if (camera.is_orthographic()) continue;
            EXPECT_FALSE(object.contains(camera.eye));
            const auto seen = object.first_hit({camera.eye, glm::normalize(*hit - camera.eye)});
            ASSERT_TRUE(seen);
            if (glm::distance(*seen, *hit) > 1e-3 * object.diagonal()) ++moved;
        }
        const double rounding = 1e-6 * distance;
        EXPECT_LT(glm::distance(navigation.camera().eye, front.eye), rounding)
            << "back where it was";
    });
    EXPECT_GT(moved, 0) << "no eye had to move";
}

TEST(Navigation, TheOtherAxisUpShowsTheModelFromTheSameSide) {
    Spheres object = head();
    Navigation navigation(object);
    navigation.frame(object.points(), kWhole, kFitDirection);
    const Vec3 direction = glm::normalize(navigation.direction());
    navigation.set_up_axis(UpAxis::z, kSize);
    EXPECT_NEAR(glm::distance(glm::normalize(navigation.direction()), direction), 0.0, 1e-9);
    EXPECT_NEAR(navigation.camera().true_up().z, std::sqrt(1.0 - direction.y * direction.y), 1e-9);
    navigation.turn(0.7, 0.0, kSize);
    EXPECT_NEAR(glm::normalize(navigation.direction()).y, direction.y, 1e-9)
        << "an orbit to the side keeps the height above the ground";
}

TEST(Navigation, CameraStaysValidHoweverFarItZooms) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Spheres object = head();
        Navigation navigation(object);
        navigation.frame(object.points(), kWhole, kFitDirection);
        navigation.set_projection(projection, kSize);
        for (const double direction : {1.0, -1.0, 1.0}) {
            for (int notch = 0; notch < 2000; ++notch) {
                navigation.zoom(direction, {10, 10}, kSize);
                ASSERT_TRUE(navigation.camera().is_valid());
            }
        }
    }
}

}  // namespace
}  // namespace pectin
