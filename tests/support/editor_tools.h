// The tools of an Editor, which it knows only as tools.
#pragma once

#include <stdexcept>

#include "app/editor.h"
#include "app/tools/cage_tool.h"
#include "app/tools/sculpt_tool.h"

namespace pectin::test {

// The tool of this type.
template <typename Kind>
const Kind& tool(const Editor& editor) {
    for (const auto& candidate : editor.tools()) {
        if (const auto* const found = dynamic_cast<const Kind*>(candidate.get())) return *found;
    }
    throw std::logic_error("the editor has no such tool");
}

inline const Sculptor& sculptor(const Editor& editor) {
    return tool<SculptTool>(editor).sculptor();
}
inline const CagePoints& cage_points(const Editor& editor) {
    return tool<CageTool>(editor).points();
}

}  // namespace pectin::test
