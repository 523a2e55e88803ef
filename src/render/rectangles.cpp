#include "render/rectangles.h"

#include <algorithm>
#include <cstdint>

namespace poinsot {

void fill_rectangle_elements(std::size_t n_rectangles) {
    std::vector<std::uint32_t> indices;
    indices.reserve(6 * n_rectangles);
    for (std::size_t k = 0; k < n_rectangles; ++k) {
        const auto corner = static_cast<std::uint32_t>(4 * k);
        indices.insert(indices.end(), {corner, corner + 1, corner + 2,  //
                                       corner + 2, corner + 1, corner + 3});
    }
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

Rectangles::Rectangles()
    : vertex_array_(GlVertexArray::make()), corners_(GlBuffer::make()), indices_(GlBuffer::make()) {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 2 * sizeof(float), nullptr);
}

void Rectangles::draw(const std::vector<PixelRect>& rects) {
    if (rects.empty()) return;
    values_.clear();
    for (const PixelRect& r : rects)
        for (const int y : {r.top, r.bottom})
            for (const int x : {r.left, r.right})
                values_.insert(values_.end(), {static_cast<float>(x), static_cast<float>(y)});
    glBindVertexArray(vertex_array_.id());
    if (rects.size() > n_most_) {
        n_most_ = std::max(rects.size(), 2 * n_most_);
        fill_rectangle_elements(n_most_);
    }
    glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values_.size() * sizeof(float)),
                 values_.data(), GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(6 * rects.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace poinsot
