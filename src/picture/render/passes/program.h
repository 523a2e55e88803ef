// OpenGL programs built from the embedded shaders.
#pragma once

#include <glad/gl.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/context/gl_handles.h"
#include "render/passes/constants.h"
#include "render/pixel_area.h"
#include "render/view_scene.h"
#include "shapes/views.h"

namespace poinsot {

// The full text of a shader: replaces `#include "file"` lines by that embedded file and inserts the
// `#define`s after the version line. Throws Error if there is no such file.
std::string shader_text(std::string_view name, const std::vector<std::string>& defines);

// A linked program with its texture units already set.
class Program {
 public:
    // Throws Error with the driver's message if a shader does not compile.
    Program(std::string_view vertex, std::string_view fragment,
            const std::vector<std::string>& defines = {});

    void use() const { glUseProgram(program_.id()); }
    // The location of a uniform; -1, which OpenGL ignores, if the shader does not use it.
    GLint at(const char* name) const { return glGetUniformLocation(program_.id(), name); }

 private:
    GlProgram program_;
};

// Set a uniform of the current program.
void set_uniform(GLint location, const glm::vec4& value);
void set_uniform(GLint location, const glm::mat3& value);
void set_uniform(GLint location, const glm::mat4& value);
void set_uniform(GLint location, std::span<const glm::vec2> values);
void set_uniform(GLint location, std::span<const glm::vec3> values);
void set_uniform(GLint location, std::span<const glm::vec4> values);

// The uniform `projection` of shaders/clip.glsl: of the pixels of a picture of this size, in which
// y runs downwards, as the rows of a framebuffer are read.
glm::mat4 projection_of(const Drawing& drawing);

// A program whose constants are passed to its fragments as in shaders/constants.glsl.
class ConstantProgram : public Program {
 public:
    // n_varyings: the number of other vectors that its vertex shader outputs.
    ConstantProgram(std::string_view vertex, std::string_view fragment, int n_constants,
                    int n_varyings, const std::vector<std::string>& defines = {});

    // Makes the program current with these constants, for a picture of this size.
    void use(const Constants& constants, const Drawing& drawing) const;

 private:
    std::size_t n_flat_, n_constants_;
    GLint constants_, more_, projection_;
};

// A program that fills convex polygons given in pixels.
class PolygonProgram : public ConstantProgram {
 public:
    PolygonProgram(std::string_view fragment, int n_constants,
                   const std::vector<std::string>& defines = {},
                   std::string_view vertex = "polygon.vert", int n_varyings = 0);
    // Precondition: a vertex array without attributes is bound.
    void draw(const PixelPolygon& polygon, const Constants& constants,
              const Drawing& drawing) const;
    // Draws only the region between `inner` and `outer`. Precondition: `inner` lies inside `outer`
    // and has the same number of corners n; the vertex shader has room for 2n + 2 corners.
    void draw_ring(const PixelPolygon& outer, const PixelPolygon& inner, const Constants& constants,
                   const Drawing& drawing) const;

 private:
    GLint corners_;
};

// Program variants by the numbers of solids in the view, made on first use: loop lengths and the
// positions of constants are known at compile time.
template <class Made>
class BySolids {
 public:
    const Made& of(const Solids& solids) {
        for (const Row& row : rows_)
            if (row.solids == solids) return *row.made;
        rows_.push_back({solids, std::make_unique<Made>(solids)});
        return *rows_.back().made;
    }

 private:
    struct Row {
        Solids solids;
        std::unique_ptr<Made> made;
    };
    std::vector<Row> rows_;
};

}  // namespace poinsot
