// The pixels in which light is gathered.
#pragma once

#include <glad/gl.h>

#include "render/context/context_info.h"

namespace poinsot {

// Linear light of 16 bits per component, as arguments of glTexImage2D.
struct LightFormat {
    GLint internal;
    GLenum type;
};
inline LightFormat light_format(LightBits bits) {
    if (bits == LightBits::integer) return {GL_RGBA16, GL_UNSIGNED_SHORT};
    return {GL_RGBA16F, GL_HALF_FLOAT};
}

}  // namespace poinsot
