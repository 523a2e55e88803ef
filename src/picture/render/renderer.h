// Draws a Drawing to an Image with an off-screen OpenGL context. render/ is the only folder that
// uses OpenGL and GLM.
#pragma once

#include <cstdint>
#include <memory>

#include "image/deep_image.h"
#include "image/image.h"
#include "render/context/offscreen_context.h"
#include "render/screen_alpha.h"
#include "shapes/views.h"

namespace poinsot {

// The work done for the last picture, for tests and benchmarks.
struct PictureCounts {
    std::int64_t n_points_uploaded = 0;   // of curves
    std::int64_t n_lasting_segments = 0;  // drawn for lasting curves, without their last segments
    std::int64_t n_tiles = 0;             // tiles of the picture that were redrawn
};

// Draws drawings on the current context; caches shaders, uploaded geometry and static content
// between calls. Move-only.
class Renderer {
 public:
    explicit Renderer(const OffscreenContext& context) : Renderer(context.info()) {}
    // On a context that is current already.
    explicit Renderer(const ContextInfo& context);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Throws InputError if the picture is larger than the context can draw.
    Image render(const Drawing& drawing);
    void render_into(const Drawing& drawing, Image& image);  // reuses the image's memory
    // Draws with 16 bits per component.
    void render_into(const Drawing& drawing, DeepImage& image);

    // Draws into a framebuffer of the context, with the bytes that render gives an opaque picture.
    // 0: the context's own. Its first row is the lowest.
    void render_to(const Drawing& drawing, unsigned framebuffer, ScreenAlpha alpha);

    PictureCounts counts() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
