// Shows the finished picture in another framebuffer, as that of a browser's canvas.
#pragma once

#include "render/context/gl_handles.h"
#include "render/passes/program.h"
#include "render/screen_alpha.h"

namespace poinsot {

class ScreenPass {
 public:
    ScreenPass();
    // Encodes the light of a picture of this size, to the bytes of Encoder, into a framebuffer
    // whose first row is the lowest. Precondition: a vertex array without attributes is bound.
    void draw(const GlTexture& light, int width_px, int height_px, GLuint framebuffer,
              ScreenAlpha alpha) const;

 private:
    Program program_;
    GLint alpha_;
    GlTexture table_;
};

}  // namespace poinsot
