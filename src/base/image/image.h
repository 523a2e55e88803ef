// A picture in memory: the output of every rendering and the input of every file.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace poinsot {

struct Rgba8 {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const Rgba8&) const = default;
};

// width × height pixels of sRGB-encoded R, G, B and linear, non-premultiplied alpha; row 0 is the
// top; 4 bytes a pixel.
class Image {
 public:
    Image() = default;
    Image(int width, int height)
        : width_(width),
          height_(height),
          bytes_(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return bytes_.empty(); }

    std::span<std::uint8_t> bytes() {
        content_ = 0;
        return bytes_;
    }
    std::span<const std::uint8_t> bytes() const { return bytes_; }

    Rgba8 at(int x, int y) const {
        const std::uint8_t* p = bytes_.data() + offset(x, y);
        return {p[0], p[1], p[2], p[3]};
    }
    void set(int x, int y, Rgba8 c) {
        content_ = 0;
        std::uint8_t* p = bytes_.data() + offset(x, y);
        p[0] = c.r, p[1] = c.g, p[2] = c.b, p[3] = c.a;
    }

    // An identifier that the writer of the pixels sets, to recognise its own output as long as
    // nothing else writes to the picture; 0: none. Copies keep the identifier.
    std::uint64_t content() const { return content_; }
    void set_content(std::uint64_t content) { content_ = content; }

    bool operator==(const Image& other) const {
        return width_ == other.width_ && height_ == other.height_ && bytes_ == other.bytes_;
    }

 private:
    std::size_t offset(int x, int y) const {
        return 4u * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(x));
    }
    int width_ = 0;
    int height_ = 0;
    std::uint64_t content_ = 0;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace poinsot
