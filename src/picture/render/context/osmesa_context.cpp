// Mesa's off-screen interface: no display, no window system, no device files.
#include <array>
#include <cstdint>

#include "render/context/native_context.h"
#include "system/shared_library.h"

namespace poinsot {
namespace {

// From GL/osmesa.h, which the build does not need, since the library is opened by name.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_rgba = 0x1908;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_stencil_bits = 0x31;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;

struct OSMesaHandle;

class OSMesaContext final : public NativeContext {
 public:
    OSMesaContext()
        : library_("libOSMesa.so.8",
                   "the Debian package libosmesa6 where there is one (Mesa has no OSMesa from 25.1 "
                   "on), else those of EGL, which draws the same"),
          destroy_(library_.function<void(OSMesaHandle*)>("OSMesaDestroyContext")),
          make_current_(library_.function<unsigned char(OSMesaHandle*, void*, GLenum, int, int)>(
              "OSMesaMakeCurrent")),
          loader_(library_.function<GLADapiproc(const char*)>("OSMesaGetProcAddress")) {
        auto* create = library_.function<OSMesaHandle*(const int*, OSMesaHandle*)>(
            "OSMesaCreateContextAttribs");
        const std::array attributes{osmesa_format,
                                    osmesa_rgba,
                                    osmesa_depth_bits,
                                    0,
                                    osmesa_stencil_bits,
                                    0,
                                    osmesa_profile,
                                    osmesa_core_profile,
                                    osmesa_major_version,
                                    3,
                                    osmesa_minor_version,
                                    3,
                                    0};
        context_ = create(attributes.data(), nullptr);
        if (context_ == nullptr) throw EnvironmentError("OSMesa gives no OpenGL 3.3 core context");
        if (make_current_(context_, buffer_.data(), GL_UNSIGNED_BYTE, side_px, side_px) == 0) {
            destroy_(context_);
            throw EnvironmentError("OSMesa cannot make its context current");
        }
    }
    ~OSMesaContext() override {
        make_current_(nullptr, nullptr, 0, 0, 0);
        destroy_(context_);
    }
    GLADloadfunc loader() const override { return loader_; }
    std::string device() const override { return "software"; }

 private:
    // Nothing is drawn to the default framebuffer, but OSMesa requires one.
    static constexpr int side_px = 16;
    std::array<std::uint8_t, 4 * side_px * side_px> buffer_{};
    SharedLibrary library_;
    void (*destroy_)(OSMesaHandle*);
    unsigned char (*make_current_)(OSMesaHandle*, void*, GLenum, int, int);
    GLADloadfunc loader_;
    OSMesaHandle* context_ = nullptr;
};

}  // namespace

std::unique_ptr<NativeContext> open_osmesa_context() { return std::make_unique<OSMesaContext>(); }

}  // namespace poinsot
