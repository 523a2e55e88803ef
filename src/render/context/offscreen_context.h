// An OpenGL context without a display.
#pragma once

#include <memory>
#include <string>

namespace poinsot {

// Whether the bytes must be the same on every processor (slower), or may use all that this one has.
enum class Portability { native, portable };

// How well the driver compiles shaders: quickly means in three fifths of the time, and drawing then
// takes an eighth longer. The bytes are the same.
enum class ShaderCompilation { thorough, quick };

// `egl` is Mesa's software renderer by EGL; `gpu` a graphics card by EGL, which `automatic` never
// is.
enum class Backend { automatic, osmesa, egl, gpu };

// What the context says of itself.
struct ContextInfo {
    std::string backend;     // "OSMesa" or "EGL"
    std::string renderer;    // GL_RENDERER
    std::string version;     // GL_VERSION
    int largest_picture_px;  // largest framebuffer side
    std::string device;      // "software", or a graphics card's device file
};

// Owns an off-screen OpenGL 3.3 core context, current on this thread while it lives. Move-only.
class OffscreenContext {
 public:
    // Throws EnvironmentError saying what was tried and which Debian package is missing.
    // A portable context is llvmpipe's, or it is refused.
    // Portability::portable must be asked for by the first context of the process; that context
    // says for all how shaders are compiled.
    explicit OffscreenContext(Backend backend = Backend::automatic,
                              Portability portability = Portability::native,
                              ShaderCompilation compilation = ShaderCompilation::thorough);
    ~OffscreenContext();
    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;

    const ContextInfo& info() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace poinsot
