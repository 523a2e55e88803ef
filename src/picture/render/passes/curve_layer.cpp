#include "render/passes/curve_layer.h"

#include <algorithm>
#include <cmath>

#include "error/error.h"

namespace poinsot {
namespace {

GlTexture make_texture(GLint format, GLenum components, int width_px, int height_px) {
    GlTexture texture = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, format, width_px, height_px, 0, components, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

}  // namespace

KeptTextures::KeptTextures(int width_px, int height_px, bool with_surface)
    : points(with_surface ? make_texture(GL_RG32F, GL_RG, width_px, height_px)
                          : make_texture(GL_R32F, GL_RED, width_px, height_px)),
      coverage(make_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, width_px, height_px)) {}

void KeptTextures::bind() const {
    glActiveTexture(GL_TEXTURE2);
    glBindTexture(GL_TEXTURE_2D, coverage.id());
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, points.id());
    glActiveTexture(GL_TEXTURE0);
}

TraceKey::TraceKey(const ViewScene& scene, const Curve& curve, const StrokeDashes& shown_dashes)
    : geometry(curve.geometry->id),
      camera(scene.view->camera),
      view(box_of(scene.projection)),
      width_px(scene.drawing->width_px),
      height_px(scene.drawing->height_px),
      placement(curve.placement.matrix()),
      stroke_px(curve.width_px),
      dashes(shown_dashes),
      first(range_of(curve).first) {
    if (const Quadric* quadric = surface_of(scene, curve)) {
        surface = quadric->axes;
        surface_centre = quadric->centre;
    }
}

bool TraceKey::operator==(const TraceKey& other) const {
    return geometry == other.geometry && camera == other.camera && view == other.view &&
           width_px == other.width_px && height_px == other.height_px &&
           placement == other.placement && surface == other.surface &&
           surface_centre == other.surface_centre && stroke_px == other.stroke_px &&
           dashes == other.dashes && first == other.first;
}

void CurveLayer::resize(int width_px, int height_px, bool with_surface) {
    if (width_px <= width_px_ && height_px <= height_px_ && (with_surface_ || !with_surface))
        return;
    width_px_ = std::max(width_px, width_px_);
    height_px_ = std::max(height_px, height_px_);
    with_surface_ = with_surface;
    textures_ = KeptTextures(width_px_, height_px_, with_surface);
    framebuffer_ = GlFramebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           textures_.points.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                           textures_.coverage.id(), 0);
    if (glGetError() != GL_NO_ERROR ||
        glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw EnvironmentError("OpenGL cannot make a curve's layer of " +
                               std::to_string(width_px_) + "x" + std::to_string(height_px_) +
                               " pixels; ask for a smaller picture");
}

void CurveLayer::restart(const TraceKey& key, const PixelBox& box, int first_segment,
                         std::uint64_t serial) {
    key_ = key;
    serial_ = serial;
    end_segment_ = first_segment;
    cells_.resize(key.width_px, key.height_px);
    grown_.resize(key.width_px, key.height_px);
    changed_.assign(grown_.n_tiles(), 0);
    // Whole tiles, limited to the picture.
    const int side = grown_.side_px();
    const auto tile = [side](double px, int size_px) {
        return std::clamp(static_cast<int>(std::floor(px / side)), 0, size_px / side);
    };
    rect_ = {};
    if (box.empty()) return;
    rect_ = {side * tile(box.left, key.width_px), side * tile(box.top, key.height_px),
             std::min(side * (tile(box.right, key.width_px) + 1), key.width_px),
             std::min(side * (tile(box.bottom, key.height_px) + 1), key.height_px)};
    if (rect_.width() <= 0 || rect_.height() <= 0) rect_ = {};
    if (rect_.width() == 0) return;
    resize(rect_.width(), rect_.height(), !key.surface.isZero(0.0));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void CurveLayer::begin_growth(const ViewScene& scene, const Curve& curve, int end_segment,
                              std::uint64_t picture) {
    grown_.clear();
    const PixelBox limits = box_of(scene.projection);
    for (int segment = end_segment_; segment < end_segment; ++segment) {
        const double from = std::max(key_.first - segment, 0.0);
        const SeenSegment seen = seen_segment(scene.projection, curve, segment, from);
        mark_stroke(seen, curve.width_px, limits, cells_);
        mark_stroke(seen, curve.width_px, limits, grown_);
    }
    for (std::size_t k = 0; k < changed_.size(); ++k)
        if (grown_.is_marked(k)) changed_[k] = picture;
    end_segment_ = end_segment;
    // Pixels have the same positions as in the picture, so that they are the same in any layer.
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(-rect_.left, -rect_.top, key_.width_px, key_.height_px);
    glDisable(GL_SCISSOR_TEST);
}

SeenSegment seen_segment(const Projection& projection, const Curve& curve, int segment, double from,
                         double to) {
    const auto point = [&](double share) -> Eigen::Vector3d {
        const auto k = static_cast<std::size_t>(segment);
        const std::vector<Eigen::Vector3d>& points = curve.geometry->points;
        return curve.placement * (points[k] + share * (points[k + 1] - points[k]));
    };
    SeenSegment seen{true, from, to, point(from), point(to), {}, {}};
    if (projection.perspective) {
        const double near_depth = projection.near_depth;
        const double depth = projection.depth(seen.start), depth_end = projection.depth(seen.end);
        if (std::max(depth, depth_end) < near_depth) return {};
        const auto share = [&](double a, double b) {
            return from + (to - from) * std::clamp((near_depth - a) / (b - a), 0.0, 1.0);
        };
        if (depth < near_depth) seen.start = point(seen.from = share(depth, depth_end));
        if (depth_end < near_depth) seen.end = point(seen.to = share(depth, depth_end));
    }
    seen.start_px = projection.place(seen.start);
    seen.end_px = projection.place(seen.end);
    return seen;
}

void mark_stroke(const SeenSegment& segment, double width_px, const PixelBox& limits,
                 TileMask& marks) {
    if (!segment.seen) return;
    const double reach = 0.5 * width_px + 1.5;
    PixelBox box;
    box.add(segment.start_px, reach);
    box.add(segment.end_px, reach);
    const Eigen::Vector2d run = segment.end_px - segment.start_px;
    if (run.cwiseAbs().minCoeff() <= marks.side_px()) return marks.mark(box.within(limits));
    const Eigen::Vector2d along = reach * run.normalized();
    const Eigen::Vector2d across(-along.y(), along.x());
    PixelPolygon polygon;
    polygon.add(segment.start_px - along - across);
    polygon.add(segment.end_px + along - across);
    polygon.add(segment.end_px + along + across);
    polygon.add(segment.start_px - along + across);
    marks.mark(polygon, limits);
}

}  // namespace poinsot
