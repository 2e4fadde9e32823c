// Selects one edge of each ring of siblings during a scan.
#pragma once

#include <unordered_set>

#include "mesh/tri_mesh.h"

namespace pectin {

// Returns true for the first edge of each ring of siblings that it is called with, and for every
// edge without siblings. Precondition: no edge is split in the meantime. Cost of a scan: O(edges),
// however many lie along one cut.
class FirstOfSiblings {
  public:
    explicit FirstOfSiblings(const TriMesh& mesh) : mesh_(mesh) {}

    bool operator()(EdgeId e) {
        const EdgeId next = mesh_.sibling(e);
        if (next == e) return true;
        if (!seen_.insert(e).second) return false;
        for (EdgeId s = next; s != e; s = mesh_.sibling(s)) seen_.insert(s);
        return true;
    }

  private:
    const TriMesh& mesh_;
    std::unordered_set<EdgeId> seen_;
};

}  // namespace pectin
