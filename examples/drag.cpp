// Opens a model, drags one point of it to a target and saves the result:
//
//     drag INPUT.obj OUTPUT.obj RADIUS FROM_X FROM_Y FROM_Z TO_X TO_Y TO_Z
//
// The surface within RADIUS of the point follows and is refined where the drag bends it. The exit
// status is 0 if the output was written, 1 if something failed and 2 if the arguments are wrong.
#include <pectin/session/session.h>

#include <cstdlib>
#include <exception>
#include <iostream>

int main(int argc, char** argv) {
    if (argc != 10) {
        std::cerr
            << "usage: drag INPUT.obj OUTPUT.obj RADIUS FROM_X FROM_Y FROM_Z TO_X TO_Y TO_Z\n";
        return 2;
    }
    double numbers[7];
    for (int i = 0; i < 7; ++i) {
        char* end = nullptr;
        numbers[i] = std::strtod(argv[i + 3], &end);
        if (end == argv[i + 3] || *end != '\0') {
            std::cerr << "drag: " << argv[i + 3] << " is not a number\n";
            return 2;
        }
    }
    const pectin::Vec3 from{numbers[1], numbers[2], numbers[3]};
    const pectin::Vec3 to{numbers[4], numbers[5], numbers[6]};

    using namespace pectin::command;
    const pectin::Command commands[] = {
        Open{.path = argv[1]},
        Adapt{.theta_max = pectin::Setting::of(12.0)},  // degrees between neighbouring normals
        Brush{.radius = numbers[0]},
        Drag{.moves = {{.from = from, .to = to}}},
        Save{.path = argv[2]},
    };
    pectin::Session session;
    try {
        for (const pectin::Command& command : commands) {
            if (const pectin::Done done = session.execute(command); !done) {
                std::cerr << "drag: " << done.refusal().reason << '\n';
                return 1;
            }
        }
    } catch (const std::exception& error) {
        std::cerr << "drag: " << error.what() << '\n';
        return 1;
    }
    std::cout << session.mesh().face_count() << " triangles\n";
}
