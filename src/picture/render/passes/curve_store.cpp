#include "render/passes/curve_store.h"

#include <algorithm>

#include "render/to_glm.h"

namespace poinsot {
namespace {

// Geometry that was not drawn for this many pictures is removed.
constexpr std::uint64_t kept_pictures = 120;

// Fills a texture with texels, in rows as shaders/curve.vert reads them. Pads the last row.
void fill(const GlTexture& texture, std::vector<glm::vec4>& texels) {
    constexpr std::size_t row = 1024;
    const std::size_t n_rows = (texels.size() + row - 1) / row;
    if (n_rows > 1) texels.resize(n_rows * row, glm::vec4(0.0f));
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(std::min(texels.size(), row)),
                 static_cast<GLsizei>(n_rows), 0, GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void upload(const CurveGeometry& geometry, StoredCurve& stored) {
    // The points, with the length of the curve up to each.
    const std::vector<Eigen::Vector3d>& points = geometry.points;
    stored.n_points = static_cast<int>(points.size());
    std::vector<glm::vec4> texels;
    texels.reserve(points.size());
    stored.lengths.reserve(points.size());
    double length = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (k > 0) length += (points[k] - points[k - 1]).norm();
        texels.emplace_back(to_glm(points[k]), length);
        stored.lengths.push_back(static_cast<float>(length));
    }
    if (geometry.closed) length += (points.front() - points.back()).norm();
    stored.length = length;
    stored.texture = GlTexture::make();
    fill(stored.texture, texels);
}

// Bounding spheres of stretches, to find the part of a picture that the curve may touch.
std::vector<CurveStretch> stretches_of(const CurveGeometry& geometry) {
    constexpr int stretch_points = 16;
    const auto n_points = static_cast<int>(geometry.points.size());
    const int n_segments = geometry.closed ? n_points : n_points - 1;
    std::vector<CurveStretch> stretches;
    for (int first = 0; first < n_segments; first += stretch_points) {
        const int last = std::min(first + stretch_points, n_segments);
        Eigen::AlignedBox3d box;
        for (int k = first; k <= last; ++k)
            box.extend(geometry.points[static_cast<std::size_t>(k % n_points)]);
        stretches.push_back({first, last, box.center(), 0.5 * box.diagonal().norm()});
    }
    return stretches;
}

}  // namespace

CurveStore::CurveStore() : vertex_array_(GlVertexArray::make()), indices_(GlBuffer::make()) {}

void CurveStore::begin_picture() {
    ++picture_;
    n_points_uploaded_ = 0;
    std::erase_if(curves_, [this](const auto& entry) {
        return entry.second.last_picture + kept_pictures < picture_;
    });
}

const StoredCurve& CurveStore::of(const CurveGeometry& geometry) {
    StoredCurve& stored = curves_[geometry.id];
    stored.last_picture = picture_;
    if (!stored.texture) {
        upload(geometry, stored);
        stored.stretches = stretches_of(geometry);
        n_points_uploaded_ += stored.n_points;
    }
    return stored;
}

void CurveStore::bind_elements(int n_rectangles) {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    if (n_rectangles <= n_rectangles_) return;
    n_rectangles_ = std::max(n_rectangles, 2 * n_rectangles_);
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * static_cast<std::size_t>(n_rectangles_));
    for (int k = 0; k < n_rectangles_; ++k) {
        const auto corner = static_cast<std::uint32_t>(4 * k);
        indices.insert(indices.end(), {corner, corner + 1, corner + 2,  //
                                       corner + 2, corner + 1, corner + 3});
    }
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

void CurveStore::bind_rectangles(const std::vector<PixelRect>& rects) {
    corners_px_.clear();
    for (const PixelRect& r : rects) corners_px_.emplace_back(r.left, r.top, r.right, r.bottom);
    if (!corners_) corners_ = GlTexture::make();
    glActiveTexture(GL_TEXTURE0);
    fill(corners_, corners_px_);
    bind_elements(static_cast<int>(rects.size()));
}

}  // namespace poinsot
