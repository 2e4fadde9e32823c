#include "app/host/offscreen_host.h"

#include <array>
#include <cstdlib>
#include <string>

#include "app/host/egl_host.h"
#include "app/host/osmesa_host.h"

namespace pectin {
namespace {

struct HostKind {
    std::string_view name;
    const char* packages;
    std::unique_ptr<OffscreenHost> (*make)(const OffscreenLibraries&);
};

// In the order in which they are tried. To add a host, write one file and register it here.
constexpr std::array kHosts{
    HostKind{
        "osmesa", "the package libosmesa6 (OSMesa)",
        [](const OffscreenLibraries& libraries) { return make_osmesa_host(libraries.osmesa); }},
    HostKind{"egl", "the packages libegl1 and libgl1-mesa-dri (EGL)",
             [](const OffscreenLibraries& libraries) { return make_egl_host(libraries.egl); }},
};

}  // namespace

std::unique_ptr<OffscreenHost> make_offscreen_host(std::string_view choice,
                                                   const OffscreenLibraries& libraries) {
    std::string names, reasons, packages;
    for (const HostKind& host : kHosts) {
        names += (names.empty() ? "" : " or ") + std::string(host.name);
        if (!choice.empty() && choice != host.name) continue;
        try {
            return host.make(libraries);
        } catch (const ContextError& error) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
            packages += (packages.empty() ? "" : " or ") + std::string(host.packages);
        }
    }
    if (reasons.empty()) {
        throw ContextError("the environment variable PECTIN_OFFSCREEN must be " + names +
                           ", or unset, not \"" + std::string(choice) + "\"");
    }
    throw ContextError("pictures cannot be drawn without a window: " + reasons + "; install " +
                       packages);
}

std::unique_ptr<OffscreenHost> make_offscreen_host() {
    const char* const choice = std::getenv("PECTIN_OFFSCREEN");
    return make_offscreen_host(choice ? choice : "");
}

}  // namespace pectin
