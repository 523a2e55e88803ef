// Selects a backend, loads the OpenGL functions and rejects a context that does not work.
#include "render/context/offscreen_context.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "error/error.h"
#include "render/context/driver_environment.h"
#include "render/context/native_context.h"
#include "system/files/processor.h"

namespace poinsot {
namespace {

struct BackendRow {
    Backend backend;
    const char* name;
    std::unique_ptr<NativeContext> (*open)();
};

// In the order in which `automatic` tries them.
constexpr std::array backends{
    BackendRow{Backend::osmesa, "OSMesa", open_osmesa_context},
    BackendRow{Backend::egl, "EGL", [] { return open_egl_context(EglDevice::software); }},
    BackendRow{Backend::gpu, "GPU", [] { return open_egl_context(EglDevice::gpu); }}};

// Mesa reads the processor's features once, at the first context of the process.
std::atomic<bool>& processor_was_read() {
    static std::atomic<bool> read{false};
    return read;
}

// Without fused multiply-add and wide vectors, llvmpipe gives the same bytes on every x86-64.
void ask_for_portable_bytes() {
    if (!has_sse41())
        throw EnvironmentError(
            "portable pictures need a processor with SSE4.1; draw native ones here, without "
            "--portable");
    const char* caps = std::getenv("GALLIUM_OVERRIDE_CPU_CAPS");
    const bool already = caps != nullptr && std::string_view(caps) == "sse4.1";
    if (processor_was_read() && !already)
        throw EnvironmentError(
            "the portable profile must be asked for by the first OpenGL context of the process");
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
}

std::string text_of(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text == nullptr ? "" : text;
}

}  // namespace

MemoryNeed memory_of_drawing() {
    // Measured with Mesa 22.3 by OSMesa and EGL, small pictures of the scenes that come along, one
    // heap for all threads (2026-11-27): at most 240 MiB of address space and 70 MiB of memory.
    // Newer Mesa and LLVM are larger. Mesa starts two threads for each processor, up to 32
    // processors, and at most five more.
    const int n_processors = static_cast<int>(std::thread::hardware_concurrency());
    return {
        .address_MiB = 300, .data_MiB = 80, .n_threads = 5 + 2 * std::clamp(n_processors, 1, 32)};
}

struct OffscreenContext::Impl {
    std::unique_ptr<NativeContext> native;
    ContextInfo info;

    // Opens one backend, or throws with the reason why it cannot be used.
    explicit Impl(const BackendRow& row) : native(row.open()) {
        if (gladLoadGL(native->loader()) == 0 || glGetString == nullptr ||
            glGetString(GL_VERSION) == nullptr)
            throw EnvironmentError(std::string(row.name) + " gives a context that does nothing");
        GLint texture_px = 0, renderbuffer_px = 0;
        std::array<GLint, 2> viewport_px{};
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture_px);
        glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &renderbuffer_px);
        glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport_px.data());
        info = {row.name, text_of(GL_RENDERER), text_of(GL_VERSION),
                std::min({texture_px, renderbuffer_px, viewport_px[0], viewport_px[1]}),
                native->device()};
        const bool software =
            info.renderer.starts_with("llvmpipe") || info.renderer.starts_with("softpipe");
        if (software == (row.backend == Backend::gpu))
            throw EnvironmentError(std::string(row.name) + " draws with " + info.renderer +
                                   (software ? ", which is not a graphics card"
                                             : ", not with Mesa's software renderer"));
    }
};

OffscreenContext::OffscreenContext(Backend backend, Portability portability,
                                   ShaderCompilation compilation) {
    check_memory("drawing", memory_of_drawing());
    if (backend != Backend::gpu) prepare_driver_environment();
    if (portability == Portability::portable) ask_for_portable_bytes();
    // llvmpipe's setting to skip LLVM's optimisations; llvmpipe reads it once. A value set by the
    // user has precedence.
    if (compilation == ShaderCompilation::quick && !processor_was_read())
        setenv("GALLIVM_PERF", "nopt", 0);
    processor_was_read() = true;
    std::string tried;
    for (const BackendRow& row : backends) {
        const bool asked = backend == row.backend;
        if (!asked && (backend != Backend::automatic || row.backend == Backend::gpu)) continue;
        try {
            impl_ = std::make_unique<Impl>(row);
            if (portability == Portability::portable &&
                !impl_->info.renderer.starts_with("llvmpipe"))
                throw EnvironmentError("draws with " + impl_->info.renderer +
                                       ", and only llvmpipe draws portable pictures");
            return;
        } catch (const EnvironmentError& failure) {
            impl_.reset();
            tried += (tried.empty() ? "" : "; ") + std::string(row.name) + ": " + failure.what();
        }
    }
    throw EnvironmentError("no OpenGL context could be made: " + tried);
}

OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

const ContextInfo& OffscreenContext::info() const { return impl_->info; }

}  // namespace poinsot
