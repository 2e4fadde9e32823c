// Compares pictures with inspected references: NAME.png in this folder.
//
// Processors and drivers round differently, so a few pixels may differ. For a driver that differs
// in more there is another reference. If a picture is close to none of them, the test writes it to
// the folder pictures/ of the build and prints its path. After an intended change, `scripts/golden`
// draws the references again; look at every one.
#pragma once

#include <string>

#include "render/canvas.h"

namespace pectin {

struct GoldenTolerance {
    double mean = 0.75;        // of 255, over all channels
    double different = 0.005;  // fraction of pixels that may differ visibly
};

// With PECTIN_REMAKE_GOLDEN=1 the picture replaces NAME.png. With another value it becomes
// NAME.VALUE.png if no reference is close.
void expect_golden(const std::string& name, const Image& image,
                   const GoldenTolerance& tolerance = {});

// Whether there is a reference of this name, and whether the picture is close to one.
bool has_golden(const std::string& name);
bool matches_golden(const std::string& name, const Image& image, const GoldenTolerance& tolerance);
// Whether the references are drawn again now.
bool remakes_golden();

}  // namespace pectin
