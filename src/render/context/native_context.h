// The two ways to a context without a display, behind one type.
#pragma once

#include <glad/gl.h>

#include <memory>
#include <string>

namespace poinsot {

// An OpenGL 3.3 core context of one backend, current on this thread from its making to its end.
class NativeContext {
 public:
    NativeContext() = default;
    NativeContext(const NativeContext&) = delete;
    NativeContext& operator=(const NativeContext&) = delete;
    virtual ~NativeContext() = default;
    virtual GLADloadfunc loader() const = 0;
    virtual std::string device() const = 0;  // what draws, for people
};

// Mesa's software renderer draws on any machine; a GPU only where it is asked for.
enum class EglDevice { software, gpu };

// Each throws EnvironmentError saying what was missing. Libraries are opened at run time, never
// linked: a program linked to two GL libraries calls the wrong one without a word.
std::unique_ptr<NativeContext> open_osmesa_context();
std::unique_ptr<NativeContext> open_egl_context(EglDevice device);

}  // namespace poinsot
