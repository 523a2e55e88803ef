#include "render/program.h"

#include <array>
#include <vector>

#include "error/error.h"
#include "render/shader_sources.h"

namespace poinsot {
namespace {

std::string_view embedded(std::string_view name) {
    for (const ShaderSource& source : shader_sources())
        if (source.name == name) return source.text;
    throw Error("there is no shader named " + std::string(name));
}

// Appends a file line by line, following its includes.
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

GlShader compiled(GLenum kind, std::string_view name, std::initializer_list<std::string> defines) {
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

std::string shader_text(std::string_view name, std::initializer_list<std::string> defines) {
    std::string text = "#version 330 core\n";
    for (const std::string& define : defines) text += "#define " + define + "\n";
    append(text, name);
    return text;
}

Program::Program(std::string_view vertex, std::string_view fragment,
                 std::initializer_list<std::string> defines)
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

    // Units and bindings are the same in every program, so that passes need not set them.
    const GLuint block = glGetUniformBlockIndex(program_.id(), "View");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), block, 0);
    use();
    glUniform1i(at("texture_0"), 0);
    glUniform1i(at("texture_1"), 1);
}

}  // namespace poinsot
