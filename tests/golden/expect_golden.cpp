#include "golden/expect_golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "io/png.h"
#include "support/paths.h"

namespace pectin {
namespace {

constexpr int kSmallDifference =
    16;  // of 255; allows for antialiased borders of lines that moved slightly
const std::string kReferences = test::source_path("tests/golden/");

struct Difference {
    double mean = 0.0;  // of 255, over all channels
    int pixels = 0;     // number of visibly different pixels

    bool is_within(const GoldenTolerance& tolerance, const IVec2& size) const {
        return mean <= tolerance.mean && pixels <= tolerance.different * size.x * size.y;
    }
};

Difference difference(const Image& image, const PngPixels& reference) {
    Difference found;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int d = std::abs(image.rgba[i + channel] - reference.rgba[i + channel]);
            found.mean += d / (3.0 * image.size.x * image.size.y);
            most = std::max(most, d);
        }
        found.pixels += most > kSmallDifference;
    }
    return found;
}

// Paths of NAME.png and of NAME.VARIANT.png for drivers that draw borders of lines differently.
std::vector<std::string> references(const std::string& name) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kReferences)) {
        const std::string file = entry.path().filename().string();
        if (file.starts_with(name + ".") && file.ends_with(".png")) paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

// Whether the picture is close to a reference. Adds the differences from all others to `report`.
bool matches(const std::string& name, const Image& image, const GoldenTolerance& tolerance,
             std::string& report) {
    for (const std::string& path : references(name)) {
        const PngPixels reference = read_png(path);
        if (reference.rgba.size() != image.rgba.size()) continue;
        const Difference found = difference(image, reference);
        if (found.is_within(tolerance, image.size)) return true;
        report += "\n  " + path + ": by " + std::to_string(found.mean) +
                  " of 255 on average, and visibly in " + std::to_string(found.pixels) + " pixels";
    }
    return false;
}

}  // namespace

void expect_golden(const std::string& name, const Image& image, const GoldenTolerance& tolerance) {
    const char* const variant = std::getenv("PECTIN_REMAKE_GOLDEN");
    std::string report;
    if (variant && variant == std::string("1")) {
        write_png(kReferences + name + ".png", image.size.x, image.size.y, image.rgba);
    } else if (matches(name, image, tolerance, report)) {
        return;
    } else if (variant) {
        write_png(kReferences + name + "." + variant + ".png", image.size.x, image.size.y,
                  image.rgba);
    } else {
        std::filesystem::create_directories(test::pictures_folder());
        const std::string path = test::pictures_folder() + "/" + name + ".png";
        write_png(path, image.size.x, image.size.y, image.rgba);
        ADD_FAILURE() << path << " differs from every reference:" << report;
    }
}

bool has_golden(const std::string& name) { return !references(name).empty(); }

bool matches_golden(const std::string& name, const Image& image, const GoldenTolerance& tolerance) {
    std::string report;
    return matches(name, image, tolerance, report);
}

bool remakes_golden() { return std::getenv("PECTIN_REMAKE_GOLDEN") != nullptr; }

}  // namespace pectin
