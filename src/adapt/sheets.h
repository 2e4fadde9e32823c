// Tests that all sheets around an inserted vertex have to pass.
#pragma once

#include "mesh/tri_mesh.h"

namespace pectin {

// True if test(const Star&) holds for every sheet at star.m. Away from cuts there is one sheet.
// Sheets along a cut are restored together, so each of them must allow it.
template <typename Test>
bool all_sheets(const TriMesh& mesh, const Star& star, Test test) {
    bool all = true;
    mesh.for_each_sheet(star, [&](const Star& sheet) { all = all && test(sheet); });
    return all;
}

}  // namespace pectin
