// EGL without a surface, needed where Mesa has no OSMesa (from 25.1 on).
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

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
constexpr unsigned egl_platform_device = 0x313F;
constexpr EglInt egl_extensions = 0x3055;
constexpr EglInt egl_drm_device_file = 0x3233;

// Whether a space-separated list of extensions contains this one.
bool has_extension(const char* list, std::string_view name) {
    std::string_view rest = list == nullptr ? "" : list;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == name) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

// A device on which EGL draws, and its name for users.
struct FoundDevice {
    EglDisplay display = nullptr;
    std::string name;
};

// The devices listed by EGL_EXT_device_enumeration.
class Devices {
 public:
    explicit Devices(const SharedLibrary& library) {
        auto* address = library.function<GLADapiproc(const char*)>("eglGetProcAddress");
        get_display_ = reinterpret_cast<GetDisplay*>(address("eglGetPlatformDisplayEXT"));
        query_string_ = reinterpret_cast<QueryString*>(address("eglQueryDeviceStringEXT"));
        auto* query = reinterpret_cast<QueryDevices*>(address("eglQueryDevicesEXT"));
        if (get_display_ == nullptr || query_string_ == nullptr || query == nullptr ||
            query(static_cast<EglInt>(devices_.size()), devices_.data(), &n_devices_) == 0)
            n_devices_ = 0;
    }

    bool known() const { return n_devices_ > 0; }

    // The first device of this kind; without a display if there is none.
    FoundDevice first(EglDevice kind) const {
        for (EglInt i = 0; i < n_devices_; ++i) {
            void* device = devices_.at(static_cast<std::size_t>(i));
            const char* extensions = query_string_(device, egl_extensions);
            const bool software = has_extension(extensions, "EGL_MESA_device_software");
            if (software != (kind == EglDevice::software)) continue;
            const char* file = has_extension(extensions, "EGL_EXT_device_drm")
                                   ? query_string_(device, egl_drm_device_file)
                                   : nullptr;
            return {get_display_(egl_platform_device, device, nullptr),
                    software          ? "software (EGL_MESA_device_software)"
                    : file != nullptr ? file
                                      : "a graphics card"};
        }
        return {};
    }

    // Mesa's platform without devices; an environment variable selects software rendering.
    FoundDevice surfaceless() const {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        if (get_display_ == nullptr) return {};
        return {get_display_(egl_platform_surfaceless_mesa, nullptr, nullptr),
                "software (surfaceless)"};
    }

 private:
    using GetDisplay = EglDisplay(unsigned, void*, const EglInt*);
    using QueryString = const char*(void*, EglInt);
    using QueryDevices = unsigned(EglInt, void**, EglInt*);

    GetDisplay* get_display_ = nullptr;
    QueryString* query_string_ = nullptr;
    std::array<void*, 32> devices_{};
    EglInt n_devices_ = 0;
};

FoundDevice find_device(const SharedLibrary& library, EglDevice kind) {
    const Devices devices(library);
    FoundDevice found = devices.known()               ? devices.first(kind)
                        : kind == EglDevice::software ? devices.surfaceless()
                                                      : FoundDevice{};
    if (found.display != nullptr) return found;
    throw EnvironmentError(
        kind == EglDevice::gpu
            ? "EGL knows no graphics card; leave --backend out to draw by software"
            : "EGL has no software device; install the Debian packages libegl-mesa0 and "
              "libgl1-mesa-dri");
}

class EglContext final : public NativeContext {
 public:
    explicit EglContext(EglDevice kind)
        : library_("libEGL.so.1", "the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri"),
          loader_(library_.function<GLADapiproc(const char*)>("eglGetProcAddress")),
          make_current_(
              library_.function<unsigned(EglDisplay, void*, void*, EglHandle)>("eglMakeCurrent")),
          destroy_(library_.function<unsigned(EglDisplay, EglHandle)>("eglDestroyContext")) {
        const FoundDevice device = find_device(library_, kind);
        display_ = device.display;
        device_ = device.name;
        auto* initialize =
            library_.function<unsigned(EglDisplay, EglInt*, EglInt*)>("eglInitialize");
        if (initialize(display_, nullptr, nullptr) == 0)
            throw EnvironmentError("EGL cannot draw on " + device_ +
                                   "; install the Debian packages libegl-mesa0 and "
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
            throw EnvironmentError("EGL gives no OpenGL 3.3 core context on " + device_);
        }
    }
    ~EglContext() override { close(); }
    GLADloadfunc loader() const override { return loader_; }
    std::string device() const override { return device_; }

 private:
    // The display stays open for the life of the process, like its library: terminating it would
    // unload the driver while Mesa still refers to it. Opening it again returns the same display.
    void close() {
        make_current_(display_, nullptr, nullptr, nullptr);
        if (context_ != nullptr) destroy_(display_, context_);
    }

    SharedLibrary library_;
    GLADloadfunc loader_;
    unsigned (*make_current_)(EglDisplay, void*, void*, EglHandle);
    unsigned (*destroy_)(EglDisplay, EglHandle);
    EglDisplay display_ = nullptr;
    std::string device_;
    EglHandle context_ = nullptr;
};

}  // namespace

std::unique_ptr<NativeContext> open_egl_context(EglDevice device) {
    return std::make_unique<EglContext>(device);
}

}  // namespace poinsot
