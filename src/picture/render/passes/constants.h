// The constants of one draw call, in the order in which the shaders number them.
#pragma once

#include <Eigen/Core>
#include <array>

namespace poinsot {

class Constants {
 public:
    // The largest number of constants in any shader program: 17, and those of eight ellipsoids and
    // four planes.
    static constexpr int capacity = 96;

    void add4(const Eigen::Vector4f& value) { values_[static_cast<std::size_t>(size_++)] = value; }
    void add(const Eigen::Vector3d& xyz, double w = 0.0) {
        add4(Eigen::Vector4f(Eigen::Vector4d(xyz.x(), xyz.y(), xyz.z(), w).cast<float>()));
    }
    void add(double x, double y, double z, double w) { add(Eigen::Vector3d(x, y, z), w); }
    int size() const { return size_; }
    const float* from(int index) const { return values_[static_cast<std::size_t>(index)].data(); }

 private:
    std::array<Eigen::Vector4f, capacity> values_;
    int size_ = 0;
};

}  // namespace poinsot
