#include "render/canvas.h"

#include "error/error.h"

namespace poinsot {

Canvas::Canvas()
    : clear_("tiles.vert", "clear.frag"),
      compose_opaque_("tiles.vert", "compose.frag"),
      compose_transparent_("tiles.vert", "compose.frag", {"TRANSPARENT"}),
      vertex_array_(GlVertexArray::make()),
      corners_(GlBuffer::make()) {}

Canvas::Layer Canvas::layer_of(int width_px, int height_px, GLint format) {
    Layer layer{GlTexture::make(), GlFramebuffer::make()};
    glBindTexture(GL_TEXTURE_2D, layer.texture.id());
    const bool encoded = format == GL_RGBA8;
    glTexImage2D(GL_TEXTURE_2D, 0, format, width_px, height_px, 0, GL_RGBA,
                 encoded ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer.texture.id(),
                           0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw EnvironmentError("OpenGL has no room for a picture of " + std::to_string(width_px) +
                               "x" + std::to_string(height_px) + " pixels; ask for a smaller one");
    return layer;
}

bool Canvas::resize(int width_px, int height_px) {
    if (width_px == width_px_ && height_px == height_px_) return false;
    still_ = layer_of(width_px, height_px, GL_RGBA16F);
    moving_ = layer_of(width_px, height_px, GL_RGBA16F);
    encoded_ = layer_of(width_px, height_px, GL_RGBA8);
    before_.resize(width_px, height_px);
    both_.resize(width_px, height_px);
    before_.fill();
    width_px_ = width_px;
    height_px_ = height_px;
    return true;
}

void Canvas::begin_still() {
    glBindFramebuffer(GL_FRAMEBUFFER, still_.framebuffer.id());
    glViewport(0, 0, width_px_, height_px_);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    before_.fill();
}

void Canvas::begin_moving(const TileMask& marks) {
    glBindFramebuffer(GL_FRAMEBUFFER, moving_.framebuffer.id());
    glViewport(0, 0, width_px_, height_px_);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    both_.clear();
    both_.join(marks);
    both_.join(before_);
    draw_tiles(clear_, both_);
}

void Canvas::compose(const TileMask& marks, bool transparent) {
    glBindFramebuffer(GL_FRAMEBUFFER, encoded_.framebuffer.id());
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, still_.texture.id());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, moving_.texture.id());
    draw_tiles(transparent ? compose_transparent_ : compose_opaque_, both_);
    before_.clear();
    before_.join(marks);
}

void Canvas::read(Image& image) const {
    if (image.width() != width_px_ || image.height() != height_px_)
        image = Image(width_px_, height_px_);
    glBindFramebuffer(GL_FRAMEBUFFER, encoded_.framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_px_, height_px_, GL_RGBA, GL_UNSIGNED_BYTE, image.bytes().data());
}

void Canvas::draw_tiles(const Program& program, const TileMask& marks) {
    corner_scratch_.clear();
    marks.append_triangles(corner_scratch_);
    if (corner_scratch_.empty()) return;
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corner_scratch_.size() * sizeof(float)),
                 corner_scratch_.data(), GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    program.use();
    glUniform4f(program.at("picture"), static_cast<float>(width_px_),
                static_cast<float>(height_px_), 1.0f / static_cast<float>(width_px_),
                1.0f / static_cast<float>(height_px_));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corner_scratch_.size() / 2));
}

}  // namespace poinsot
