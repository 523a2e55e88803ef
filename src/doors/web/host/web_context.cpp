#include "web/host/web_context.h"

#include <glad/gl.h>

#include <algorithm>

#include "error/error.h"
#include "render/context/gl_handles.h"

namespace poinsot {

// Whether the context has textures of 16-bit integers (EXT_texture_norm16) that can be drawn into.
extern "C" __attribute__((import_module("page"), import_name("has_integer_light"))) int
has_integer_light();

ContextInfo web_context() {
    GLint texture_px = 0, renderbuffer_px = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture_px);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer_px);
    return {"WebGL",   "",
            "",        std::min(texture_px, renderbuffer_px),
            "browser", has_integer_light() != 0 ? LightBits::integer : LightBits::half};
}

std::string pixels_of(Renderer& renderer, const Drawing& drawing) {
    const GlRenderbuffer colours = GlRenderbuffer::make();
    const GlFramebuffer framebuffer = GlFramebuffer::make();
    glBindRenderbuffer(GL_RENDERBUFFER, colours.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, drawing.width_px, drawing.height_px);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colours.id());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw EnvironmentError(
            "the browser has no memory for a picture of this size; ask for a "
            "smaller one");
    renderer.render_to(drawing, framebuffer.id(), ScreenAlpha::straight);
    const auto row = 4 * static_cast<std::size_t>(drawing.width_px);
    const auto n_rows = static_cast<std::size_t>(drawing.height_px);
    std::string pixels(row * n_rows, '\0');
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, drawing.width_px, drawing.height_px, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    // From the lowest row first to the highest.
    for (std::size_t y = 0; y < n_rows / 2; ++y)
        std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                         pixels.begin() + static_cast<std::ptrdiff_t>((n_rows - 1 - y) * row));
    return pixels;
}

}  // namespace poinsot
