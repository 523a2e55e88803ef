// Drawing → Image on an off-screen OpenGL context. The only folder that knows OpenGL and GLM.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawing.h"
#include "image/deep_image.h"
#include "image/image.h"

namespace poinsot {

// Whether the bytes must be the same on every processor (slower), or may use all that this one has.
enum class Portability { native, portable };

// How well the driver compiles shaders: quickly means in three fifths of the time, and drawing then
// takes an eighth longer. The bytes are the same.
enum class ShaderCompilation { thorough, quick };

enum class Backend { automatic, osmesa, egl };

// What the context says of itself.
struct ContextInfo {
    std::string backend;     // "OSMesa" or "EGL"
    std::string renderer;    // GL_RENDERER
    std::string version;     // GL_VERSION
    int largest_picture_px;  // largest framebuffer side
};

// Owns an off-screen OpenGL 3.3 core context, current on this thread while it lives. Move-only.
class OffscreenContext {
 public:
    // Throws EnvironmentError saying what was tried and which Debian package is missing.
    // Portability::portable must be asked for by the first context of the process; that context
    // says for all how shaders are compiled.
    explicit OffscreenContext(Backend backend = Backend::automatic,
                              Portability portability = Portability::native,
                              ShaderCompilation compilation = ShaderCompilation::thorough);
    ~OffscreenContext();
    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;

    const ContextInfo& info() const;

    // To be told once the first pictures are drawn: gives back what starting up and compiling
    // shaders has read of the libraries, some 60 MiB, most of it the compiler's.
    void shaders_are_compiled() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

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
