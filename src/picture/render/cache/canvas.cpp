#include "render/cache/canvas.h"

#include <algorithm>
#include <cstring>

#include "error/error.h"
#include "shapes/identity.h"

namespace poinsot {
namespace {

// Rows read back at a time: they fit into the CPU cache.
constexpr int band_px = 32;

}  // namespace

Canvas::Layer Canvas::make_layer(bool with_depth) const {
    Layer layer;
    layer.texture = GlTexture::make();
    layer.framebuffer = GlFramebuffer::make();
    glBindTexture(GL_TEXTURE_2D, layer.texture.id());
    const LightFormat format = light_format(light_);
    glTexImage2D(GL_TEXTURE_2D, 0, format.internal, width_px_, height_px_, 0, GL_RGBA, format.type,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, layer.texture.id(),
                           0);
    if (with_depth) {
        layer.depth = GlRenderbuffer::make();
        glBindRenderbuffer(GL_RENDERBUFFER, layer.depth.id());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width_px_, height_px_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  layer.depth.id());
    }
    if (glGetError() != GL_NO_ERROR ||
        glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw EnvironmentError("OpenGL cannot make a picture of " + std::to_string(width_px_) +
                               "x" + std::to_string(height_px_) + " pixels; ask for a smaller one");
    return layer;
}

bool Canvas::resize(int width_px, int height_px) {
    if (width_px == width_px_ && height_px == height_px_) return false;
    width_px_ = width_px;
    height_px_ = height_px;
    picture_ = make_layer(true);
    still_ = Layer{};
    scratch_.resize(4 * static_cast<std::size_t>(width_px) * band_px);
    return true;
}

void Canvas::begin(const Layer& layer) const {
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.id());
    glViewport(0, 0, width_px_, height_px_);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Canvas::begin_whole() { begin(picture_); }

void Canvas::resume() const {
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer.id());
    glViewport(0, 0, width_px_, height_px_);
}

void Canvas::begin_still() {
    if (!still_.texture) still_ = make_layer(false);
    begin(still_);
}

void Canvas::begin_still_on_top() { restore({{0, 0, width_px_, height_px_}}); }

void Canvas::keep_still(bool transparent, std::size_t n_tiles) {
    read_all(picture_, still_image_, transparent);
    kept_stamps_.assign(n_tiles, 0);
    kept_at_.assign(n_tiles, 0);
    for (Written& written : written_) written.content = 0;
}

void Canvas::keep_tile(const TileMask& marks, std::size_t tile, std::uint64_t stamp,
                       const Image& image) {
    copy(marks.rect(tile), image, still_image_);
    kept_stamps_[tile] = stamp;
    kept_at_[tile] = n_pictures_;
}

void Canvas::begin_over_still(const TileMask& marks) {
    rects_.clear();
    marks.add_rects(nullptr, rects_);
    restore(rects_);
}

void Canvas::restore(const std::vector<PixelRect>& rects) const {
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, width_px_, height_px_);
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer.id());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, still_.framebuffer.id());
    for (const PixelRect& r : rects)
        glBlitFramebuffer(r.left, r.top, r.right, r.bottom, r.left, r.top, r.right, r.bottom,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, picture_.framebuffer.id());
}

void Canvas::read_whole(Image& image, bool transparent) { read_all(picture_, image, transparent); }

void Canvas::read_all(const Layer& layer, Image& image, bool transparent) {
    if (image.width() != width_px_ || image.height() != height_px_)
        image = Image(width_px_, height_px_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, layer.framebuffer.id());
    for (int top = 0; top < height_px_; top += band_px)
        read({0, top, width_px_, std::min(top + band_px, height_px_)}, image, transparent);
}

void Canvas::read_whole(DeepImage& image, bool transparent) {
    if (image.width() != width_px_ || image.height() != height_px_)
        image = DeepImage(width_px_, height_px_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    std::uint16_t* out = image.samples().data();
    for (int top = 0; top < height_px_; top += band_px) {
        const int n_rows = std::min(band_px, height_px_ - top);
        glReadPixels(0, top, width_px_, n_rows, GL_RGBA, GL_UNSIGNED_SHORT, scratch_.data());
        const int n = width_px_ * n_rows;
        encoder_.encode_deep(scratch_.data(), n, transparent, out);
        out += 4 * static_cast<std::ptrdiff_t>(n);
    }
}

void Canvas::read_over_still(const TileMask& marks, Image& image, bool transparent) {
    if (image.width() != width_px_ || image.height() != height_px_)
        image = Image(width_px_, height_px_);
    // Copies the static content to the tiles where the image differs or is unknown.
    const auto before = std::find_if(written_.begin(), written_.end(), [&](const Written& w) {
        return w.content != 0 && w.content == image.content();
    });
    copied_ = marks;
    copied_.clear();
    for (std::size_t k = 0; k < marks.n_tiles(); ++k)
        if (!marks.is_marked(k) && (before == written_.end() || before->marks.is_marked(k) ||
                                    kept_at_[k] > before->picture))
            copied_.mark(k);
    rects_.clear();
    copied_.add_rects(nullptr, rects_);
    for (const PixelRect& rect : rects_) copy(rect, still_image_, image);

    rects_.clear();
    marks.add_rects(nullptr, rects_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture_.framebuffer.id());
    for (PixelRect rect : rects_) {
        const int bottom = rect.bottom;
        const int most_rows = band_px * width_px_ / rect.width();
        for (int top = rect.top; top < bottom; top += most_rows)
            read({rect.left, top, rect.right, std::min(top + most_rows, bottom)}, image,
                 transparent);
    }

    Written& written = written_[++n_pictures_ % written_.size()];
    written.content = next_identity();
    written.picture = n_pictures_;
    written.marks = marks;
    image.set_content(written.content);
}

void Canvas::copy(const PixelRect& rect, const Image& from, Image& to) const {
    const auto row_size = 4 * static_cast<std::size_t>(width_px_);
    const std::size_t n = 4 * static_cast<std::size_t>(std::max(rect.width(), 0));
    if (n == 0) return;
    for (int y = rect.top; y < rect.bottom; ++y) {
        const std::size_t first =
            static_cast<std::size_t>(y) * row_size + 4 * static_cast<std::size_t>(rect.left);
        std::memcpy(to.bytes().data() + first, from.bytes().data() + first, n);
    }
}

void Canvas::read(const PixelRect& rect, Image& image, bool transparent) {
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(rect.left, rect.top, rect.width(), rect.height(), GL_RGBA, GL_UNSIGNED_SHORT,
                 scratch_.data());
    const std::uint16_t* row = scratch_.data();
    for (int y = rect.top; y < rect.bottom; ++y) {
        const auto first = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px_) +
                           static_cast<std::size_t>(rect.left);
        std::uint8_t* out = image.bytes().data() + 4 * first;
        if (transparent)
            encoder_.encode_transparent(row, rect.left, y, rect.width(), out);
        else
            encoder_.encode_opaque(row, rect.left, y, rect.width(), out);
        row += 4 * static_cast<std::ptrdiff_t>(rect.width());
    }
}

}  // namespace poinsot
