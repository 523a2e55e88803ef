// EGL without a surface: the way where Mesa no longer has OSMesa (from 25.1 on).
#include <array>
#include <cstdint>

#include "render/context/native_context.h"
#include "system/shared_library.h"

namespace poinsot {
namespace {

// From EGL/egl.h and EGL/eglext.h.
using EglDisplay = void*;
using EglConfig = void*;
using EglHandle = void*;
using EglInt = std::int32_t;
constexpr unsigned egl_platform_surfaceless_mesa = 0x31DD;
constexpr unsigned egl_opengl_api = 0x30A2;
constexpr EglInt egl_none = 0x3038;
constexpr EglInt egl_major_version = 0x3098;
constexpr EglInt egl_minor_version = 0x30FB;
constexpr EglInt egl_profile_mask = 0x30FD;
constexpr EglInt egl_core_profile_bit = 1;

class EglContext final : public NativeContext {
 public:
    EglContext()
        : library_("libEGL.so.1", "libegl1"),
          loader_(library_.function<GLADapiproc(const char*)>("eglGetProcAddress")),
          make_current_(
              library_.function<unsigned(EglDisplay, void*, void*, EglHandle)>("eglMakeCurrent")),
          destroy_(library_.function<unsigned(EglDisplay, EglHandle)>("eglDestroyContext")) {
        using GetDisplay = EglDisplay(unsigned, void*, const EglInt*);
        auto* get_display = reinterpret_cast<GetDisplay*>(loader_("eglGetPlatformDisplayEXT"));
        auto* initialize =
            library_.function<unsigned(EglDisplay, EglInt*, EglInt*)>("eglInitialize");
        if (get_display != nullptr)
            display_ = get_display(egl_platform_surfaceless_mesa, nullptr, nullptr);
        if (display_ == nullptr || initialize(display_, nullptr, nullptr) == 0)
            throw EnvironmentError(
                "EGL has no surfaceless platform; install the Debian packages libegl-mesa0 and "
                "libgl1-mesa-dri");

        library_.function<unsigned(unsigned)>("eglBindAPI")(egl_opengl_api);
        const std::array<EglInt, 7> attributes{
            egl_major_version,    3,       egl_minor_version, 3, egl_profile_mask,
            egl_core_profile_bit, egl_none};
        auto* create =
            library_.function<EglHandle(EglDisplay, EglConfig, EglHandle, const EglInt*)>(
                "eglCreateContext");
        context_ = create(display_, nullptr, nullptr, attributes.data());
        if (context_ == nullptr || make_current_(display_, nullptr, nullptr, context_) == 0) {
            close();
            throw EnvironmentError("EGL gives no surfaceless OpenGL 3.3 core context");
        }
    }
    ~EglContext() override { close(); }
    GLADloadfunc loader() const override { return loader_; }

 private:
    // The display stays for the life of the process, as its library does: to end it would unload
    // the driver under what Mesa still keeps of it. Opened again, it is the same one.
    void close() {
        make_current_(display_, nullptr, nullptr, nullptr);
        if (context_ != nullptr) destroy_(display_, context_);
    }

    SharedLibrary library_;
    GLADloadfunc loader_;
    unsigned (*make_current_)(EglDisplay, void*, void*, EglHandle);
    unsigned (*destroy_)(EglDisplay, EglHandle);
    EglDisplay display_ = nullptr;
    EglHandle context_ = nullptr;
};

}  // namespace

std::unique_ptr<NativeContext> open_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace poinsot
