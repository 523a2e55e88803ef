#include "render/context/driver_environment.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "error/error.h"

namespace poinsot {

namespace {

// Tried with Mesa 22.3: vectors of another width crash llvmpipe or give other bytes, as do the
// switches of LP_PERF and ST_DEBUG, and CPUs without SSE; the others end in no context, a crash or
// a hang.
constexpr std::array meant_for_debugging{"LP_NATIVE_VECTOR_WIDTH",
                                         "LP_PERF",
                                         "ST_DEBUG",
                                         "DRAW_USE_LLVM",
                                         "GALLIUM_NOOP",
                                         "GALLIUM_NOSSE",
                                         "GALLIUM_TRACE",
                                         "MESA_EXTENSION_OVERRIDE",
                                         "MESA_GL_VERSION_OVERRIDE",
                                         "MESA_GLSL_VERSION_OVERRIDE",
                                         "force_glsl_version"};

constexpr std::array<std::string_view, 3> known_drivers{"", "llvmpipe", "softpipe"};

}  // namespace

void prepare_driver_environment() {
    for (const char* variable : meant_for_debugging) unsetenv(variable);
    const char* given = std::getenv("GALLIUM_DRIVER");
    const std::string driver = given == nullptr ? "" : given;
    if (std::find(known_drivers.begin(), known_drivers.end(), driver) == known_drivers.end())
        throw EnvironmentError("GALLIUM_DRIVER=" + driver +
                               ": not a software renderer of Mesa that poinsot uses; unset "
                               "GALLIUM_DRIVER, or set it to llvmpipe or softpipe");
}

}  // namespace poinsot
