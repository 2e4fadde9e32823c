// The list of tools. To add one, write a file of this folder that defines a class and a function
// which makes it, and add the function to the list.
#include "app/tools/tool.h"

namespace pectin {

using MakeTool = std::unique_ptr<Tool>();
MakeTool make_cage_tool, make_pin_tool, make_sculpt_tool, make_radius_tool;

Tools all_tools() {
    Tools tools;
    for (MakeTool* const make : {
             make_cage_tool,    // control points lie in front of the surface
             make_pin_tool,     // while it is on, clicks on the surface do not drag
             make_sculpt_tool,  // drags the surface
             make_radius_tool,  // waits for its key
         }) {
        tools.push_back(make());
    }
    return tools;
}

}  // namespace pectin
