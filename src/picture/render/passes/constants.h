// The constants of one draw call, in the order in which the shaders number them.
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>

#include "render/to_glm.h"

namespace poinsot {

class Constants {
 public:
    // The largest number of constants in any shader program: 17, and those of eight ellipsoids and
    // four planes.
    static constexpr int capacity = 96;

    void add(const glm::vec4& value) { values_[size_++] = value; }
    void add(const Eigen::Vector3d& xyz, double w = 0.0) { add(glm::vec4(to_glm(xyz), w)); }
    void add(double x, double y, double z, double w) { add(glm::vec4(x, y, z, w)); }
    std::span<const glm::vec4> values() const { return std::span(values_).first(size_); }

 private:
    std::array<glm::vec4, capacity> values_;
    std::size_t size_ = 0;
};

}  // namespace poinsot
