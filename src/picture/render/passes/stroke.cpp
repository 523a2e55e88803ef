#include "render/passes/stroke.h"

#include <algorithm>
#include <cmath>

namespace poinsot {
namespace {

// The uniform part of a placement's scale.
double scale_of(const Eigen::Affine3d& placement) {
    return std::cbrt(std::abs(placement.linear().determinant()));
}

}  // namespace

ShownRange range_of(const Curve& curve) {
    const auto n = static_cast<int>(curve.geometry->points.size());
    const int n_segments = curve.geometry->closed ? n : n - 1;
    if (n < 2) return {};
    const double first = std::clamp(curve.first, 0.0, static_cast<double>(n_segments));
    const double last = std::clamp(curve.last, 0.0, static_cast<double>(n_segments));
    if (!(first <= last) || curve.first > curve.last) return {};
    const int first_segment = std::min(static_cast<int>(std::floor(first)), n_segments - 1);
    const int end_segment = std::max(static_cast<int>(std::ceil(last)), first_segment + 1);
    return {first, last, first_segment, end_segment};
}

bool shows(const Curve& curve) {
    return curve.geometry != nullptr && curve.opacity > 0.0 && curve.width_px > 0.0 &&
           !range_of(curve).empty();
}

StrokeDashes dashes_of(const ViewScene& scene, const Curve& curve, double length) {
    // Lengths apply at the depth of the camera's target; a closed curve has a whole number of
    // dashes.
    const Projection& p = scene.projection;
    const double unit_px = p.scale(std::max(p.depth(scene.view->camera.target), p.near_depth)) *
                           scale_of(curve.placement);
    const bool solid = !(curve.dash_px > 0.0);
    // Where hidden, as in PDF and SVG: shorter on a short curve.
    constexpr double least_widths = 3.0, most_widths = 6.0, gap_share = 0.5;
    const double thin_px = curve.hidden_share * curve.width_px;
    const double hidden_px =
        std::clamp(length * unit_px / 16.0, least_widths * thin_px, most_widths * thin_px);
    const double dash_px = solid ? hidden_px : curve.dash_px;
    double gap_px = curve.gap_px > 0.0 ? curve.gap_px : dash_px;
    if (solid) gap_px = gap_share * dash_px;
    double period = (dash_px + gap_px) / unit_px;
    if (curve.geometry->closed) period = length / std::max(1.0, std::round(length / period));
    if (solid) period = curve.hidden == HiddenStyle::dashed ? -period : 0.0;
    return {period, dash_px / (dash_px + gap_px)};
}

const Quadric* surface_of(const ViewScene& scene, const Curve& curve) {
    if (curve.occlusion != Occlusion::by_solids) return nullptr;
    if (curve.on_surface < 0 || curve.on_surface >= scene.n_quadrics()) return nullptr;
    return &scene.quadrics[static_cast<std::size_t>(curve.on_surface)];
}

StrokeProgram::StrokeProgram(std::string_view fragment, int n_constants,
                             const std::vector<std::string>& defines)
    : ConstantProgram("curve.vert", fragment, n_constants, 4, defines),
      n_points_(at("n_points")),
      closed_(at("closed")),
      stroke_(at("stroke")),
      on_ellipsoid_(at("on_ellipsoid")),
      in_rectangles_(at("in_rectangles")) {}

void StrokeProgram::draw(const ViewScene& scene, const Curve& curve, const ShownRange& range,
                         double width_px, const Constants& constants, CurveStore& store) const {
    const StoredCurve& stored = store.of(*curve.geometry);
    const Quadric* surface = surface_of(scene, curve);
    Constants stroke;
    stroke.add(range.first, range.last, width_px, stored.length);
    for (int row = 0; row < 3; ++row)
        stroke.add(curve.placement.linear().row(row).transpose(),
                   curve.placement.translation()[row]);
    for (int row = 0; row < 3; ++row) {
        if (surface == nullptr)
            stroke.add(0.0, 0.0, 0.0, 0.0);
        else
            stroke.add(surface->to_u_row(row), surface->to_u_offset(row));
    }
    stroke.add(surface == nullptr ? Eigen::Vector3d::Zero() : surface->eye_u,
               scene.projection.perspective ? 1.0 : 0.0);

    use(constants, *scene.drawing);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, stored.texture.id());
    glUniform1i(n_points_, stored.n_points);
    glUniform1i(closed_, curve.geometry->closed ? 1 : 0);
    set_uniform(stroke_, stroke.values());
    glUniform1i(on_ellipsoid_, surface == nullptr ? 0 : 1);
    glUniform1i(in_rectangles_, 0);
    const int n_segments = range.end_segment - range.first_segment;
    store.bind_elements(range.end_segment);
    // OpenGL takes an offset into the buffer as a pointer.
    const void* const first = reinterpret_cast<const void*>(  // NOLINT(performance-no-int-to-ptr)
        6 * sizeof(std::uint32_t) * static_cast<std::size_t>(range.first_segment));
    glDrawElements(GL_TRIANGLES, 6 * n_segments, GL_UNSIGNED_INT, first);
}

void StrokeProgram::draw(const ViewScene& scene, const StrokeEnds& ends,
                         const std::vector<PixelRect>& rects, const Constants& constants,
                         CurveStore& store) const {
    Constants stroke;
    stroke.add(ends.from_px.x(), ends.from_px.y(), ends.to_px.x(), ends.to_px.y());
    stroke.add(ends.depth_from, ends.depth_to, ends.facing_from, ends.facing_to);
    stroke.add(ends.length_from, ends.length_to, 0.0, 0.0);
    use(constants, *scene.drawing);
    set_uniform(stroke_, stroke.values());
    glUniform1i(in_rectangles_, 1);
    store.bind_rectangles(rects);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * rects.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace poinsot
