#include "render/passes/program.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "error/error.h"
#include "render/context/dialect.h"
#include "render/passes/shader_sources.h"

namespace poinsot {
namespace {

std::string_view embedded(std::string_view name) {
    for (const ShaderSource& source : shader_sources())
        if (source.name == name) return source.text;
    throw Error("there is no shader named " + std::string(name));
}

// Appends a file line by line, with its includes.
void append(std::string& out, std::string_view name) {
    std::string_view rest = embedded(name);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end);
        constexpr std::string_view include = "#include \"";
        if (line.starts_with(include)) {
            const std::string_view tail = line.substr(include.size());
            append(out, tail.substr(0, tail.find('"')));
        } else {
            out += line;
        }
    }
}

GlShader compiled(GLenum kind, std::string_view name, const std::vector<std::string>& defines) {
    GlShader shader(kind);
    const std::string text = shader_text(name, defines);
    const char* start = text.c_str();
    glShaderSource(shader.id(), 1, &start, nullptr);
    glCompileShader(shader.id());
    GLint ok = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
    if (ok == 0) {
        std::array<char, 2048> log{};
        glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error("shader " + std::string(name) + " does not compile: " + log.data());
    }
    return shader;
}

}  // namespace

std::string shader_text(std::string_view name, const std::vector<std::string>& defines) {
    std::string text = dialect == Dialect::desktop
                           ? "#version 330 core\n"
                           // w is 1 in all shapes with noperspective.
                           : "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                             "precision highp sampler2D;\n#define noperspective\n";
    text += "#define real float\n";
    for (const std::string& define : defines) text += "#define " + define + "\n";
    append(text, name);
    return text;
}

Program::Program(std::string_view vertex, std::string_view fragment,
                 const std::vector<std::string>& defines)
    : program_(GlProgram::make()) {
    const GlShader vertex_shader = compiled(GL_VERTEX_SHADER, vertex, defines);
    const GlShader fragment_shader = compiled(GL_FRAGMENT_SHADER, fragment, defines);
    glAttachShader(program_.id(), vertex_shader.id());
    glAttachShader(program_.id(), fragment_shader.id());
    glLinkProgram(program_.id());
    GLint ok = 0;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &ok);
    if (ok == 0) {
        std::array<char, 2048> log{};
        glGetProgramInfoLog(program_.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw Error("shaders " + std::string(vertex) + " and " + std::string(fragment) +
                    " do not link: " + log.data());
    }
    glDetachShader(program_.id(), vertex_shader.id());
    glDetachShader(program_.id(), fragment_shader.id());

    use();
    glUniform1i(at("texture_0"), 0);
    glUniform1i(at("texture_1"), 1);
    glUniform1i(at("texture_2"), 2);
    glUniform1i(at("texture_3"), 3);
}

namespace {

// llvmpipe and OpenGL 3.3 pass 32 vectors to a fragment, including its position.
constexpr int most_varyings = 31;

int n_flat(int n_constants, int n_varyings) {
    if (dialect == Dialect::es) return n_constants;  // all are uniforms
    return std::min(n_constants, most_varyings - n_varyings);
}

// The defines of shaders/constants.glsl, followed by those of the program.
std::vector<std::string> with_counts(int n_constants, int n_varyings,
                                     const std::vector<std::string>& defines) {
    std::vector<std::string> all{"N_CONSTANTS " + std::to_string(n_constants),
                                 "N_FLAT " + std::to_string(n_flat(n_constants, n_varyings))};
    all.insert(all.end(), defines.begin(), defines.end());
    return all;
}

}  // namespace

ConstantProgram::ConstantProgram(std::string_view vertex, std::string_view fragment,
                                 int n_constants, int n_varyings,
                                 const std::vector<std::string>& defines)
    : Program(vertex, fragment, with_counts(n_constants, n_varyings, defines)),
      n_flat_(static_cast<std::size_t>(n_flat(n_constants, n_varyings))),
      n_constants_(static_cast<std::size_t>(n_constants)),
      constants_(at("constants")),
      more_(at("more_constants")),
      projection_(at("projection")) {}

void ConstantProgram::use(const Constants& constants, const Drawing& drawing) const {
    const std::span<const glm::vec4> values = constants.values();
    assert(values.size() == n_constants_);
    Program::use();
    set_uniform(constants_, values.first(n_flat_));
    if (n_constants_ > n_flat_) set_uniform(more_, values.subspan(n_flat_));
    set_uniform(projection_, projection_of(drawing));
}

void set_uniform(GLint location, const glm::vec4& value) {
    glUniform4fv(location, 1, glm::value_ptr(value));
}

void set_uniform(GLint location, const glm::mat3& value) {
    glUniformMatrix3fv(location, 1, GL_FALSE, glm::value_ptr(value));
}

void set_uniform(GLint location, const glm::mat4& value) {
    glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(value));
}

void set_uniform(GLint location, std::span<const glm::vec2> values) {
    glUniform2fv(location, static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

void set_uniform(GLint location, std::span<const glm::vec3> values) {
    glUniform3fv(location, static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

void set_uniform(GLint location, std::span<const glm::vec4> values) {
    glUniform4fv(location, static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
}

glm::mat4 projection_of(const Drawing& drawing) {
    return glm::ortho(0.0f, static_cast<float>(drawing.width_px), 0.0f,
                      static_cast<float>(drawing.height_px));
}

PolygonProgram::PolygonProgram(std::string_view fragment, int n_constants,
                               const std::vector<std::string>& defines, std::string_view vertex,
                               int n_varyings)
    : ConstantProgram(vertex, fragment, n_constants, n_varyings, defines),
      corners_(at("corners")) {}

void PolygonProgram::draw(const PixelPolygon& polygon, const Constants& constants,
                          const Drawing& drawing) const {
    if (polygon.n_corners == 0) return;
    use(constants, drawing);
    set_uniform(corners_, polygon.added());
    glDrawArrays(GL_TRIANGLE_FAN, 0, polygon.n_corners);
}

void PolygonProgram::draw_ring(const PixelPolygon& outer, const PixelPolygon& inner,
                               const Constants& constants, const Drawing& drawing) const {
    std::array<glm::vec2, 2 * (PixelPolygon::most_corners + 1)> corners;
    for (int k = 0; k <= outer.n_corners; ++k) {
        const auto corner = static_cast<std::size_t>(k % outer.n_corners);
        corners[2 * static_cast<std::size_t>(k)] = outer.corners[corner];
        corners[2 * static_cast<std::size_t>(k) + 1] = inner.corners[corner];
    }
    use(constants, drawing);
    const int n_corners = 2 * (outer.n_corners + 1);
    set_uniform(corners_, std::span(corners).first(static_cast<std::size_t>(n_corners)));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, n_corners);
}

}  // namespace poinsot
