// Properties of an OpenGL context.
#pragma once

#include <string>

namespace poinsot {

// How the 16 bits of a component of light are stored: as an integer or, in a browser that offers no
// others, as a half-precision number.
enum class LightBits { integer, half };

// Properties of the context.
struct ContextInfo {
    std::string backend;     // "OSMesa" or "EGL"
    std::string renderer;    // GL_RENDERER
    std::string version;     // GL_VERSION
    int largest_picture_px;  // largest side of a framebuffer
    std::string device;      // "software", or a graphics card's device file
    LightBits light = LightBits::integer;
};

}  // namespace poinsot
