// A picture with 16 bits per component, for print: the output of rendering and the input of files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poinsot {

// width × height pixels of sRGB-encoded R, G, B and linear, non-premultiplied alpha, each from 0 to
// 65535; row 0 is the top.
class DeepImage {
 public:
    DeepImage() = default;
    DeepImage(int width, int height)
        : width_(width),
          height_(height),
          samples_(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return samples_.empty(); }
    std::span<std::uint16_t> samples() { return samples_; }
    std::span<const std::uint16_t> samples() const { return samples_; }

    bool operator==(const DeepImage&) const = default;

 private:
    int width_ = 0, height_ = 0;
    std::vector<std::uint16_t> samples_;
};

}  // namespace poinsot
