// Move-only owners of OpenGL objects: the destructor deletes the object, which needs the context
// that created it.
#pragma once

#include <glad/gl.h>

#include <utility>

namespace poinsot {

// One OpenGL object name; Traits creates and deletes it.
template <class Traits>
class GlHandle {
 public:
    GlHandle() = default;
    ~GlHandle() { release(); }
    GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        if (this != &other) {
            release();
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }

    static GlHandle make() { return GlHandle(Traits::make()); }

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

 private:
    explicit GlHandle(GLuint id) : id_(id) {}
    void release() {
        if (id_ != 0) Traits::free(id_);
        id_ = 0;
    }
    GLuint id_ = 0;
};

struct GlBufferTraits {
    static GLuint make() {
        GLuint id = 0;
        glGenBuffers(1, &id);
        return id;
    }
    static void free(GLuint id) { glDeleteBuffers(1, &id); }
};

struct GlTextureTraits {
    static GLuint make() {
        GLuint id = 0;
        glGenTextures(1, &id);
        return id;
    }
    static void free(GLuint id) { glDeleteTextures(1, &id); }
};

struct GlRenderbufferTraits {
    static GLuint make() {
        GLuint id = 0;
        glGenRenderbuffers(1, &id);
        return id;
    }
    static void free(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

struct GlFramebufferTraits {
    static GLuint make() {
        GLuint id = 0;
        glGenFramebuffers(1, &id);
        return id;
    }
    static void free(GLuint id) { glDeleteFramebuffers(1, &id); }
};

struct GlVertexArrayTraits {
    static GLuint make() {
        GLuint id = 0;
        glGenVertexArrays(1, &id);
        return id;
    }
    static void free(GLuint id) { glDeleteVertexArrays(1, &id); }
};

struct GlProgramTraits {
    static GLuint make() { return glCreateProgram(); }
    static void free(GLuint id) { glDeleteProgram(id); }
};

using GlBuffer = GlHandle<GlBufferTraits>;
using GlTexture = GlHandle<GlTextureTraits>;
using GlRenderbuffer = GlHandle<GlRenderbufferTraits>;
using GlFramebuffer = GlHandle<GlFramebufferTraits>;
using GlVertexArray = GlHandle<GlVertexArrayTraits>;
using GlProgram = GlHandle<GlProgramTraits>;

// A shader whose type is a run-time argument.
class GlShader {
 public:
    explicit GlShader(GLenum kind) : id_(glCreateShader(kind)) {}
    ~GlShader() { glDeleteShader(id_); }
    GlShader(GlShader&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlShader& operator=(GlShader&&) = delete;
    GLuint id() const { return id_; }

 private:
    GLuint id_;
};

}  // namespace poinsot
