// An OpenGL context without a display.
#pragma once

#include <memory>

#include "render/context/context_info.h"
#include "system/files/memory_limits.h"

namespace poinsot {

// Whether the bytes must be the same on every processor (slower), or the driver may use all
// features of this processor.
enum class Portability { native, portable };

// The optimisation level of the driver's shader compiler: `quick` compiles in 60 % of the time, and
// drawing then takes an eighth longer. The bytes are the same.
enum class ShaderCompilation { thorough, quick };

// `egl` is Mesa's software renderer with EGL; `gpu` is a graphics card with EGL, which `automatic`
// never selects.
enum class Backend { automatic, osmesa, egl, gpu };

// The most memory for opening a context, with Mesa's libraries, and drawing a small picture.
MemoryNeed memory_of_drawing();

// Owns an off-screen OpenGL 3.3 core context, current on this thread during its lifetime.
// Move-only.
class OffscreenContext {
 public:
    // Throws EnvironmentError that says what was tried and which Debian package is missing, or that
    // the process may not take the memory that Mesa needs. A
    // portable context requires llvmpipe. If any context of the process is portable, the first one
    // must be; the first context also determines how shaders are compiled in all later ones.
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
