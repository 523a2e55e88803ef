// The text of numbers, colours, paths and bytes in SVG.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "vector/sheet_of_paper.h"

namespace poinsot::vector::svg {

// The unit is 1/256 pt (1.4 µm), as in Cairo's PDF: coordinates are short integers.
constexpr double units_per_pt = 256.0;

inline std::int64_t rounded(double pt) { return std::llround(units_per_pt * pt); }
inline std::string number(double pt) { return std::to_string(rounded(pt)); }

// Formats a share, 0…1.
std::string share(double value);

// The transform from own axes to the paper, in points.
std::string matrix(const Eigen::Affine2d& map);

// Characters that XML cannot hold become U+FFFD.
std::string escaped(std::string_view text);
std::string unescaped(std::string_view text);

std::string base64(std::string_view bytes);

// Path data. Each step is relative to the rounded end of the previous one, so that rounding errors
// do not accumulate.
class PathData {
 public:
    void add(const Path& path, const Eigen::Affine2d& map = Eigen::Affine2d::Identity());
    std::string take() { return std::move(text_); }

 private:
    void line(const Eigen::Vector2d& to);
    void begin(char command, std::initializer_list<Eigen::Vector2d> points);

    std::string text_;
    char last_ = 0;
    std::int64_t x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
};

// The data of one path.
std::string data_of(const Path& path);

}  // namespace poinsot::vector::svg
