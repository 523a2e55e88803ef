// The part of OpenGL ES 3.0 that src/render/ calls, imported from page/program.js, which calls
// WebGL. It stands in for the loader of the native program.
#pragma once

#include <cstddef>
#include <cstdint>

using GLenum = unsigned;
using GLboolean = unsigned char;
using GLbitfield = unsigned;
using GLint = int;
using GLuint = unsigned;
using GLsizei = int;
using GLfloat = float;
using GLchar = char;
using GLubyte = unsigned char;
using GLsizeiptr = std::ptrdiff_t;

#define GL_ARRAY_BUFFER 0x8892
#define GL_BLEND 0x0BE2
#define GL_CLAMP_TO_EDGE 0x812F
#define GL_COLOR_ATTACHMENT0 0x8CE0
#define GL_COLOR_BUFFER_BIT 0x00004000
#define GL_COMPILE_STATUS 0x8B81
#define GL_DEPTH_ATTACHMENT 0x8D00
#define GL_DEPTH_BUFFER_BIT 0x00000100
#define GL_DEPTH_COMPONENT 0x1902
#define GL_DEPTH_COMPONENT32F 0x8CAC
#define GL_DEPTH_TEST 0x0B71
#define GL_DRAW_FRAMEBUFFER 0x8CA9
#define GL_ELEMENT_ARRAY_BUFFER 0x8893
#define GL_FALSE 0
#define GL_FLOAT 0x1406
#define GL_FRAGMENT_SHADER 0x8B30
#define GL_FRAMEBUFFER 0x8D40
#define GL_FRAMEBUFFER_COMPLETE 0x8CD5
#define GL_FUNC_ADD 0x8006
#define GL_HALF_FLOAT 0x140B
#define GL_LESS 0x0201
#define GL_LINEAR 0x2601
#define GL_LINEAR_MIPMAP_LINEAR 0x2703
#define GL_LINK_STATUS 0x8B82
#define GL_MAX_TEXTURE_SIZE 0x0D33
#define GL_MAX_RENDERBUFFER_SIZE 0x84E8
#define GL_NEAREST 0x2600
#define GL_NO_ERROR 0
#define GL_ONE 1
#define GL_ONE_MINUS_SRC_ALPHA 0x0303
#define GL_PACK_ALIGNMENT 0x0D05
#define GL_R16UI 0x8234
#define GL_R32F 0x822E
#define GL_READ_FRAMEBUFFER 0x8CA8
#define GL_RED 0x1903
#define GL_RED_INTEGER 0x8D94
#define GL_RENDERBUFFER 0x8D41
#define GL_RG 0x8227
#define GL_RG32F 0x8230
#define GL_RG8 0x822B
#define GL_RGB 0x1907
#define GL_RGB8 0x8051
#define GL_RGBA 0x1908
#define GL_RGBA16 0x805B
#define GL_RGBA16F 0x881A
#define GL_RGBA32F 0x8814
#define GL_RGBA8 0x8058
#define GL_SCISSOR_TEST 0x0C11
#define GL_STATIC_DRAW 0x88E4
#define GL_STREAM_DRAW 0x88E0
#define GL_TEXTURE0 0x84C0
#define GL_TEXTURE1 0x84C1
#define GL_TEXTURE2 0x84C2
#define GL_TEXTURE3 0x84C3
#define GL_TEXTURE_2D 0x0DE1
#define GL_TEXTURE_MAG_FILTER 0x2800
#define GL_TEXTURE_MAX_LEVEL 0x813D
#define GL_TEXTURE_MIN_FILTER 0x2801
#define GL_TEXTURE_WRAP_S 0x2802
#define GL_TEXTURE_WRAP_T 0x2803
#define GL_TRIANGLES 0x0004
#define GL_TRIANGLE_FAN 0x0006
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRUE 1
#define GL_UNPACK_ALIGNMENT 0x0CF5
#define GL_UNSIGNED_BYTE 0x1401
#define GL_UNSIGNED_INT 0x1405
#define GL_UNSIGNED_SHORT 0x1403
#define GL_VERTEX_SHADER 0x8B31

#define POINSOT_GL(name) __attribute__((import_module("gl"), import_name(#name)))
extern "C" {
POINSOT_GL(glActiveTexture) void glActiveTexture(GLenum texture);
POINSOT_GL(glAttachShader) void glAttachShader(GLuint program, GLuint shader);
POINSOT_GL(glBindBuffer) void glBindBuffer(GLenum target, GLuint buffer);
POINSOT_GL(glBindFramebuffer) void glBindFramebuffer(GLenum target, GLuint framebuffer);
POINSOT_GL(glBindRenderbuffer) void glBindRenderbuffer(GLenum target, GLuint renderbuffer);
POINSOT_GL(glBindTexture) void glBindTexture(GLenum target, GLuint texture);
POINSOT_GL(glBindVertexArray) void glBindVertexArray(GLuint array);
POINSOT_GL(glBlendEquation) void glBlendEquation(GLenum mode);
POINSOT_GL(glBlendFunc) void glBlendFunc(GLenum sfactor, GLenum dfactor);
POINSOT_GL(glBlitFramebuffer)
void glBlitFramebuffer(GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0, GLint dstY0,
                       GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter);
POINSOT_GL(glBufferData)
void glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage);
POINSOT_GL(glCheckFramebufferStatus) GLenum glCheckFramebufferStatus(GLenum target);
POINSOT_GL(glClear) void glClear(GLbitfield mask);
POINSOT_GL(glClearColor) void glClearColor(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
POINSOT_GL(glCompileShader) void glCompileShader(GLuint shader);
POINSOT_GL(glCreateProgram) GLuint glCreateProgram();
POINSOT_GL(glCreateShader) GLuint glCreateShader(GLenum type);
POINSOT_GL(glDeleteBuffers) void glDeleteBuffers(GLsizei n, const GLuint* buffers);
POINSOT_GL(glDeleteFramebuffers) void glDeleteFramebuffers(GLsizei n, const GLuint* framebuffers);
POINSOT_GL(glDeleteProgram) void glDeleteProgram(GLuint program);
POINSOT_GL(glDeleteRenderbuffers)
void glDeleteRenderbuffers(GLsizei n, const GLuint* renderbuffers);
POINSOT_GL(glDeleteShader) void glDeleteShader(GLuint shader);
POINSOT_GL(glDeleteTextures) void glDeleteTextures(GLsizei n, const GLuint* textures);
POINSOT_GL(glDeleteVertexArrays) void glDeleteVertexArrays(GLsizei n, const GLuint* arrays);
POINSOT_GL(glDepthFunc) void glDepthFunc(GLenum func);
POINSOT_GL(glDetachShader) void glDetachShader(GLuint program, GLuint shader);
POINSOT_GL(glDisable) void glDisable(GLenum cap);
POINSOT_GL(glDrawArrays) void glDrawArrays(GLenum mode, GLint first, GLsizei count);
POINSOT_GL(glDrawElements)
void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* indices);
POINSOT_GL(glEnable) void glEnable(GLenum cap);
POINSOT_GL(glEnableVertexAttribArray) void glEnableVertexAttribArray(GLuint index);
POINSOT_GL(glFramebufferRenderbuffer)
void glFramebufferRenderbuffer(GLenum target, GLenum attachment, GLenum renderbuffertarget,
                               GLuint renderbuffer);
POINSOT_GL(glFramebufferTexture2D)
void glFramebufferTexture2D(GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                            GLint level);
POINSOT_GL(glGenBuffers) void glGenBuffers(GLsizei n, GLuint* buffers);
POINSOT_GL(glGenFramebuffers) void glGenFramebuffers(GLsizei n, GLuint* framebuffers);
POINSOT_GL(glGenRenderbuffers) void glGenRenderbuffers(GLsizei n, GLuint* renderbuffers);
POINSOT_GL(glGenTextures) void glGenTextures(GLsizei n, GLuint* textures);
POINSOT_GL(glGenVertexArrays) void glGenVertexArrays(GLsizei n, GLuint* arrays);
POINSOT_GL(glGenerateMipmap) void glGenerateMipmap(GLenum target);
POINSOT_GL(glGetError) GLenum glGetError();
POINSOT_GL(glGetIntegerv) void glGetIntegerv(GLenum pname, GLint* data);
POINSOT_GL(glGetProgramInfoLog)
void glGetProgramInfoLog(GLuint program, GLsizei bufSize, GLsizei* length, GLchar* infoLog);
POINSOT_GL(glGetProgramiv) void glGetProgramiv(GLuint program, GLenum pname, GLint* params);
POINSOT_GL(glGetShaderInfoLog)
void glGetShaderInfoLog(GLuint shader, GLsizei bufSize, GLsizei* length, GLchar* infoLog);
POINSOT_GL(glGetShaderiv) void glGetShaderiv(GLuint shader, GLenum pname, GLint* params);
POINSOT_GL(glGetUniformLocation) GLint glGetUniformLocation(GLuint program, const GLchar* name);
POINSOT_GL(glLinkProgram) void glLinkProgram(GLuint program);
POINSOT_GL(glPixelStorei) void glPixelStorei(GLenum pname, GLint param);
POINSOT_GL(glReadPixels)
void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                  void* pixels);
POINSOT_GL(glRenderbufferStorage)
void glRenderbufferStorage(GLenum target, GLenum internalformat, GLsizei width, GLsizei height);
POINSOT_GL(glScissor) void glScissor(GLint x, GLint y, GLsizei width, GLsizei height);
POINSOT_GL(glShaderSource)
void glShaderSource(GLuint shader, GLsizei count, const GLchar* const* string, const GLint* length);
POINSOT_GL(glTexImage2D)
void glTexImage2D(GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void* pixels);
POINSOT_GL(glTexParameteri) void glTexParameteri(GLenum target, GLenum pname, GLint param);
POINSOT_GL(glTexSubImage2D)
void glTexSubImage2D(GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                     GLsizei height, GLenum format, GLenum type, const void* pixels);
POINSOT_GL(glUniform1i) void glUniform1i(GLint location, GLint v0);
POINSOT_GL(glUniform2f) void glUniform2f(GLint location, GLfloat v0, GLfloat v1);
POINSOT_GL(glUniform2fv) void glUniform2fv(GLint location, GLsizei count, const GLfloat* value);
POINSOT_GL(glUniform3fv) void glUniform3fv(GLint location, GLsizei count, const GLfloat* value);
POINSOT_GL(glUniform4f)
void glUniform4f(GLint location, GLfloat v0, GLfloat v1, GLfloat v2, GLfloat v3);
POINSOT_GL(glUniform4fv) void glUniform4fv(GLint location, GLsizei count, const GLfloat* value);
POINSOT_GL(glUseProgram) void glUseProgram(GLuint program);
POINSOT_GL(glVertexAttribPointer)
void glVertexAttribPointer(GLuint index, GLint size, GLenum type, GLboolean normalized,
                           GLsizei stride, const void* pointer);
POINSOT_GL(glViewport) void glViewport(GLint x, GLint y, GLsizei width, GLsizei height);
}
#undef POINSOT_GL
