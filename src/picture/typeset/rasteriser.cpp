#include "typeset/rasteriser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poinsot {
namespace {

// Largest distance of a chord from its cubic. The lost area along an edge is two thirds of it, a
// third of the 1/255 that a mask can represent.
constexpr double flatness_px = 0.002;
constexpr int max_chords = 4096;

OutlinePoint second_difference(OutlinePoint a, OutlinePoint b, OutlinePoint c) {
    return {a.x - 2.0 * b.x + c.x, a.y - 2.0 * b.y + c.y};
}
double square(OutlinePoint p) { return p.x * p.x + p.y * p.y; }

}  // namespace

GlyphOutline make_outline(std::vector<OutlineStep> steps) {
    GlyphOutline outline;
    bool first = true;
    const auto include = [&](OutlinePoint p) {
        outline.min_x = first ? p.x : std::min(outline.min_x, p.x);
        outline.max_x = first ? p.x : std::max(outline.max_x, p.x);
        outline.min_y = first ? p.y : std::min(outline.min_y, p.y);
        outline.max_y = first ? p.y : std::max(outline.max_y, p.y);
        first = false;
    };
    for (const OutlineStep& step : steps) {
        if (step.kind == OutlineStep::Kind::cubic) include(step.control_1), include(step.control_2);
        include(step.to);
    }
    outline.steps = std::move(steps);
    return outline;
}

Rasteriser::Rasteriser(int width, int first_row, int n_rows)
    : width_(width),
      first_row_(first_row),
      n_rows_(n_rows),
      stride_(static_cast<std::size_t>(width) + 2),
      difference_(stride_ * static_cast<std::size_t>(n_rows)) {}

void Rasteriser::add(const GlyphOutline& outline, double x_px, double y_px, double px_per_unit) {
    const auto place = [=](OutlinePoint p) {
        return OutlinePoint{x_px + p.x * px_per_unit, y_px - p.y * px_per_unit};
    };
    // Skip outlines that do not reach this band of rows.
    if (y_px - outline.min_y * px_per_unit < first_row_ ||
        y_px - outline.max_y * px_per_unit > first_row_ + n_rows_) {
        return;
    }
    OutlinePoint start, at;
    for (const OutlineStep& step : outline.steps) {
        const OutlinePoint to = place(step.to);
        switch (step.kind) {
            case OutlineStep::Kind::move:
                line(at, start);
                start = to;
                break;
            case OutlineStep::Kind::line:
                line(at, to);
                break;
            case OutlineStep::Kind::cubic:
                cubic(at, place(step.control_1), place(step.control_2), to);
                break;
        }
        at = to;
    }
    line(at, start);
}

void Rasteriser::add_rectangle(double left, double top, double right, double bottom) {
    line({left, top}, {left, bottom});
    line({right, bottom}, {right, top});
}

// Divides the cubic into n chords of equal parameter length. By Wang's bound, the distance from a
// chord is at most 6·max|second difference| / (8 n²) (G. Wang, 1984).
void Rasteriser::cubic(OutlinePoint p0, OutlinePoint p1, OutlinePoint p2, OutlinePoint p3) {
    const double bend =
        std::max(square(second_difference(p0, p1, p2)), square(second_difference(p1, p2, p3)));
    const double wanted = std::sqrt(0.75 * std::sqrt(bend) / flatness_px);
    const int n = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, double{max_chords}));
    OutlinePoint at = p0;
    for (int i = 1; i <= n; ++i) {
        const double t = static_cast<double>(i) / n;
        const double s = 1.0 - t;
        const double b0 = s * s * s, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t, b3 = t * t * t;
        const OutlinePoint to = i == n
                                    ? p3
                                    : OutlinePoint{b0 * p0.x + b1 * p1.x + b2 * p2.x + b3 * p3.x,
                                                   b0 * p0.y + b1 * p1.y + b2 * p2.y + b3 * p3.y};
        line(at, to);
        at = to;
    }
}

// Cuts an edge at the rows that it crosses.
void Rasteriser::line(OutlinePoint from, OutlinePoint to) {
    if (from.y == to.y) return;
    // Downward edges count as positive.
    const double direction = from.y < to.y ? 1.0 : -1.0;
    if (direction < 0.0) std::swap(from, to);
    const double top = std::max(from.y, static_cast<double>(first_row_));
    const double bottom = std::min(to.y, static_cast<double>(first_row_ + n_rows_));
    if (top >= bottom) return;
    const auto cells = [this](int row) {
        return difference_.data() + stride_ * static_cast<std::size_t>(row - first_row_);
    };
    // Most chords of a letter's curves lie within one row.
    int row = static_cast<int>(top);
    const auto edge = static_cast<double>(width_);
    if (top == from.y && bottom == to.y && bottom <= row + 1.0) {
        row_part(cells(row), std::clamp(from.x, 0.0, edge), std::clamp(to.x, 0.0, edge),
                 direction * (bottom - top));
        return;
    }

    const double slope = (to.x - from.x) / (to.y - from.y);
    const double left = std::clamp(std::min(from.x, to.x), 0.0, edge);
    const double right = std::clamp(std::max(from.x, to.x), 0.0, edge);
    const auto x_at = [&](double y) {
        return std::clamp(from.x + (y - from.y) * slope, left, right);
    };
    double y = top;
    double x = x_at(top);
    for (; y < bottom; ++row) {
        const double y_next = std::min(bottom, row + 1.0);
        const double x_next = x_at(y_next);
        row_part(cells(row), x, x_next, direction * (y_next - y));
        y = y_next;
        x = x_next;
    }
}

// Cuts an edge within one row at the columns that it crosses. A part of height h whose middle is at
// a fraction m of its column covers h·(1 − m) of that column and h of every later one.
void Rasteriser::row_part(double* row, double x0, double x1, double height) {
    if (x0 > x1) std::swap(x0, x1);
    const int first = std::min(static_cast<int>(x0), width_);
    if (x1 <= first + 1.0) {
        const double middle = 0.5 * (x0 + x1) - first;
        row[first] += height * (1.0 - middle);
        row[first + 1] += height * middle;
        return;
    }
    const double per_column = height / (x1 - x0);
    double x = x0;
    for (int column = first; x < x1; ++column) {
        const double next = std::min(x1, column + 1.0);
        const double part = per_column * (next - x);
        const double middle = 0.5 * (x + next) - column;
        row[column] += part * (1.0 - middle);
        row[column + 1] += part * middle;
        x = next;
    }
}

template <typename Store>
void Rasteriser::sum_rows(Store store) const {
    for (int row = 0; row < n_rows_; ++row) {
        const double* cells = difference_.data() + stride_ * static_cast<std::size_t>(row);
        double winding = 0.0;
        for (int column = 0; column < width_; ++column) {
            winding += cells[column];
            store(std::min(1.0, std::abs(winding)));
        }
    }
}

std::vector<double> Rasteriser::coverage() const {
    std::vector<double> covered(static_cast<std::size_t>(width_) *
                                static_cast<std::size_t>(n_rows_));
    auto at = covered.begin();
    sum_rows([&at](double part) { *at++ = part; });
    return covered;
}

void Rasteriser::write(std::uint8_t* rows) const {
    // Coverage is never negative, so adding a half and truncating rounds to nearest.
    constexpr double a_half = 0.5;
    sum_rows([&rows](double part) { *rows++ = static_cast<std::uint8_t>(255.0 * part + a_half); });
}

}  // namespace poinsot
