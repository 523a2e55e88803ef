// Drawing → Image on an off-screen OpenGL context. The only folder that knows OpenGL and GLM.
#pragma once

#include <cstdint>
#include <memory>

#include "image/deep_image.h"
#include "image/image.h"
#include "render/context/offscreen_context.h"
#include "shapes/views.h"

namespace poinsot {

// What the last picture took, for tests and benchmarks.
struct PictureCounts {
    std::int64_t n_points_uploaded = 0;   // of curves
    std::int64_t n_lasting_segments = 0;  // drawn of curves that last, but for their last ones
    std::int64_t n_tiles = 0;             // squares of the picture drawn anew
};

// Draws drawings on the current context; keeps shaders, uploaded geometry and what stands still
// between calls. Move-only.
class Renderer {
 public:
    explicit Renderer(const OffscreenContext& context);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    // Throws InputError if the picture is larger than the context can draw.
    Image render(const Drawing& drawing);
    void render_into(const Drawing& drawing, Image& image);  // reuses the image's memory
    // In 16 bits a component.
    void render_into(const Drawing& drawing, DeepImage& image);

    PictureCounts counts() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
