// A common interface for the two ways to create a context without a display.
#pragma once

#include <glad/gl.h>

#include <memory>
#include <string>

namespace poinsot {

// An OpenGL 3.3 core context of one backend, current on this thread during its lifetime.
class NativeContext {
 public:
    NativeContext() = default;
    NativeContext(const NativeContext&) = delete;
    NativeContext& operator=(const NativeContext&) = delete;
    virtual ~NativeContext() = default;
    virtual GLADloadfunc loader() const = 0;
    virtual std::string device() const = 0;  // the device, for display to users
};

// Mesa's software renderer works on any machine; a GPU is used only on request.
enum class EglDevice { software, gpu };

// Each throws EnvironmentError that says what is missing. Libraries are opened at run time, never
// linked: a program linked to two GL libraries would silently call the wrong one.
std::unique_ptr<NativeContext> open_osmesa_context();
std::unique_ptr<NativeContext> open_egl_context(EglDevice device);

}  // namespace poinsot
