// OpenGL programs built from the embedded shaders.
#pragma once

#include <glad/gl.h>

#include <Eigen/Core>
#include <initializer_list>
#include <string>
#include <string_view>

#include "render/gl_handles.h"

namespace poinsot {

// The full text of a shader: `#include "file"` lines replaced by that embedded file, `#define`s
// put after the version line. Throws Error if there is no such file.
std::string shader_text(std::string_view name, std::initializer_list<std::string> defines);

// A linked program with its texture units and the block "View" (at binding 0) already set.
class Program {
 public:
    // Throws Error with the driver's message if a shader does not compile.
    Program(std::string_view vertex, std::string_view fragment,
            std::initializer_list<std::string> defines = {});

    void use() const { glUseProgram(program_.id()); }
    // Location of a uniform; -1, which OpenGL ignores, if the shader makes no use of it.
    GLint at(const char* name) const { return glGetUniformLocation(program_.id(), name); }

 private:
    GlProgram program_;
};

}  // namespace poinsot
