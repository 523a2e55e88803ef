#include "render/curve_pass.h"

#include <algorithm>
#include <cmath>

#include "render/colour.h"

namespace poinsot {
namespace {

// Pictures after which a geometry that is no longer drawn is forgotten.
constexpr std::uint64_t kept_pictures = 120;

// The part of a curve that is shown: points from first to last, and the whole segments about it.
struct Range {
    double first, last;
    int first_segment, end_segment;
    bool empty() const { return first_segment >= end_segment; }
};

Range range_of(const Curve& curve) {
    const auto n = static_cast<int>(curve.geometry->points.size());
    const int n_segments = curve.geometry->closed ? n : n - 1;
    if (n < 2) return {0.0, 0.0, 0, 0};
    const double first = std::clamp(curve.first, 0.0, static_cast<double>(n_segments));
    const double last = std::clamp(curve.last, 0.0, static_cast<double>(n_segments));
    if (!(first <= last) || curve.first > curve.last) return {0.0, 0.0, 0, 0};
    const int first_segment = std::min(static_cast<int>(std::floor(first)), n_segments - 1);
    const int end_segment = std::max(static_cast<int>(std::ceil(last)), first_segment + 1);
    return {first, last, first_segment, end_segment};
}

std::vector<std::string> with(std::vector<std::string> defines, const std::string& another) {
    defines.push_back(another);
    return defines;
}

// Uniform part of a placement's scale.
double scale_of(const Eigen::Affine3d& placement) {
    return std::cbrt(std::abs(placement.linear().determinant()));
}

}  // namespace

CurvePass::Stroke::Stroke(const Solids& solids)
    : program("curve.vert", "curve.frag", 9 + solids.n_constants(), 4,
              with(solids.defines(), "FADE " + std::to_string(8 + solids.n_constants()))),
      n_points(program.at("n_points")),
      closed(program.at("closed")),
      stroke(program.at("stroke")),
      on_ellipsoid(program.at("on_ellipsoid")) {}

CurvePass::CurvePass() : vertex_array_(GlVertexArray::make()), indices_(GlBuffer::make()) {}

void CurvePass::begin_picture() {
    ++picture_;
    std::erase_if(uploads_, [this](const auto& entry) {
        return entry.second.last_picture + kept_pictures < picture_;
    });
}

CurvePass::Uploaded& CurvePass::uploaded(const CurveGeometry& geometry) {
    Uploaded& upload = uploads_[geometry.id];
    upload.last_picture = picture_;
    if (upload.buffer) return upload;

    // Points with the length of the curve up to each.
    const std::vector<Eigen::Vector3d>& points = geometry.points;
    upload.n_points = static_cast<int>(points.size());
    std::vector<Eigen::Vector4f> texels;
    texels.reserve(points.size());
    double length = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k > 0) length += (points[k] - points[k - 1]).norm();
        texels.emplace_back(points[k].cast<float>().x(), points[k].cast<float>().y(),
                            points[k].cast<float>().z(), static_cast<float>(length));
    }
    if (geometry.closed) length += (points.front() - points.back()).norm();
    upload.length = length;
    upload.buffer = GlBuffer::make();
    upload.texture = GlTexture::make();
    glBindBuffer(GL_TEXTURE_BUFFER, upload.buffer.id());
    glBufferData(GL_TEXTURE_BUFFER,
                 static_cast<GLsizeiptr>(texels.size() * sizeof(Eigen::Vector4f)), texels.data(),
                 GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, upload.texture.id());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, upload.buffer.id());

    // Balls about stretches of it say which tiles it touches.
    constexpr int stretch_points = 16;
    const int n_segments = geometry.closed ? upload.n_points : upload.n_points - 1;
    for (int first = 0; first < n_segments; first += stretch_points) {
        const int last = std::min(first + stretch_points, n_segments);
        const auto point = [&](int k) {
            return points[static_cast<std::size_t>(k % upload.n_points)];
        };
        Eigen::AlignedBox3d box;
        for (int k = first; k <= last; ++k) box.extend(point(k));
        upload.stretches.push_back({first, last, box.center(), 0.5 * box.diagonal().norm()});
    }
    return upload;
}

void CurvePass::reserve_segments(int n_segments) {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    if (n_segments <= n_segments_) return;
    n_segments_ = std::max(n_segments, 2 * n_segments_);
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * static_cast<std::size_t>(n_segments_));
    for (int k = 0; k < n_segments_; ++k) {
        const auto corner = static_cast<std::uint32_t>(4 * k);
        indices.insert(indices.end(), {corner, corner + 1, corner + 2,  //
                                       corner + 2, corner + 1, corner + 3});
    }
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

void CurvePass::draw(const ViewScene& scene, const Curve& curve) {
    if (curve.geometry == nullptr || curve.opacity <= 0.0 || curve.width_px <= 0.0) return;
    const Range range = range_of(curve);
    if (range.empty()) return;
    const Uploaded& upload = uploaded(*curve.geometry);
    reserve_segments(range.end_segment);

    // A curve drawn in full needs no solids.
    const bool occluded = curve.occlusion == Occlusion::by_solids;
    const Stroke& made = occluded ? strokes_.of(scene.solids()) : strokes_.of(Solids{});
    const int own = occluded && curve.on_surface < scene.n_quadrics() ? curve.on_surface : -1;

    // Dashes are as long as asked for where the camera looks; a closed curve has whole ones.
    const Projection& p = scene.projection;
    const double unit_px = p.unit_px(std::max(p.depth(scene.view->camera.target), p.near_depth)) *
                           scale_of(curve.placement);
    const bool solid = !(curve.dash_px > 0.0);
    const double dash_px = solid ? 2.0 * curve.width_px : curve.dash_px;
    const double gap_px = solid || !(curve.gap_px > 0.0) ? dash_px : curve.gap_px;
    double period = (dash_px + gap_px) / unit_px;
    if (curve.geometry->closed)
        period = upload.length / std::max(1.0, std::round(upload.length / period));
    if (solid) period = curve.hidden == HiddenStyle::dashed ? -period : 0.0;

    Constants constants;
    scene.add_view(constants);
    constants.add4(linear_from_srgb(curve.colour, curve.opacity));
    constants.add(curve.width_px, curve.hidden == HiddenStyle::absent ? -1.0 : curve.hidden_opacity,
                  own, curve.on_plane);
    const Quadric* surface = own < 0 ? nullptr : &scene.quadrics[static_cast<std::size_t>(own)];
    constants.add(period, dash_px / (dash_px + gap_px),
                  surface == nullptr ? 0.0 : surface->limb_cosine(),
                  surface == nullptr ? 0.0 : surface->hiding);
    if (occluded) scene.add_solids(constants);
    // Each curve lies a step before all that were drawn earlier, so that the depth buffer need not
    // be emptied for every picture. Steps are powers of two and depths lie between 1/2 and 1: what
    // is compared is rounded alike in whatever step it is drawn.
    constexpr double depth_step = 1.0 / 1024.0;
    if (++n_drawn_ >= 512) {
        glDisable(GL_SCISSOR_TEST);  // of all views
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        n_drawn_ = 1;
    }
    constants.add(range.last - curve.fade_points, range.last, 1.0 - n_drawn_ * depth_step,
                  0.9 * depth_step);

    Constants stroke;
    stroke.add(range.first, range.last, curve.width_px, upload.length);
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
               p.perspective ? 1.0 : 0.0);

    made.program.use(constants, *scene.drawing);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, upload.texture.id());
    glUniform1i(made.n_points, upload.n_points);
    glUniform1i(made.closed, curve.geometry->closed ? 1 : 0);
    glUniform4fv(made.stroke, stroke.size(), stroke.from(0));
    glUniform1i(made.on_ellipsoid, surface == nullptr ? 0 : 1);
    const auto offset =
        static_cast<std::uintptr_t>(range.first_segment) * 6 * sizeof(std::uint32_t);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDrawElements(GL_TRIANGLES, 6 * (range.end_segment - range.first_segment), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    glDisable(GL_DEPTH_TEST);
}

void CurvePass::mark(const ViewScene& scene, const Curve& curve, TileMask& marks) {
    if (curve.geometry == nullptr || curve.opacity <= 0.0 || curve.width_px <= 0.0) return;
    const Range range = range_of(curve);
    if (range.empty()) return;
    const double scale = curve.placement.linear().colwise().norm().maxCoeff();
    const double margin = 0.5 * curve.width_px + 2.0;
    for (const Stretch& stretch : uploaded(*curve.geometry).stretches) {
        if (stretch.last < range.first_segment || stretch.first > range.end_segment) continue;
        PixelBox box =
            scene.projection.ball_box(curve.placement * stretch.centre, scale * stretch.radius);
        box.left -= margin, box.top -= margin, box.right += margin, box.bottom += margin;
        marks.mark(box.within(scene.projection.box));
    }
}

}  // namespace poinsot
