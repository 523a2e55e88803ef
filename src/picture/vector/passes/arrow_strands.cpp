#include "vector/passes/arrow_strands.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace poinsot::vector {

ArrowStrands::ArrowStrands(const Canvas& canvas, const ArrowShape& shape, ArrowPart part)
    : projection_(canvas.projection),
      shape_(shape),
      part_(part),
      from_(shape.begin_of(part)),
      to_(shape.end_of(part)) {
    // The lines on the near side begin at one end of a circle's outline on the paper: its other
    // end is two open radii further along the axis.
    const double radius = part == ArrowPart::shaft ? shape.shaft_radius : shape.head_radius;
    constexpr double most_radii = 2.0;
    const double radii = shape.open / std::sqrt(std::max(1.0 - shape.open * shape.open, 1e-6));
    beyond_ = 2.0 * std::min(radii, most_radii) * radius / (shape.tip - shape.tail).norm();
    // Seen along its axis, the arrow has one line.
    if (shape.to_front.isZero(0.0)) {
        strands_.push_back(strand_at(canvas, 0.0));
        return;
    }
    for (const double side : {-1.0, 0.0, 1.0}) {
        Strand next = strand_at(canvas, side);
        if (!strands_.empty()) refine(canvas, Strand(strands_.back()), next, 0);
        strands_.push_back(std::move(next));
    }
}

std::vector<Cover> ArrowStrands::covers() const {
    std::vector<Cover> found;
    for (const Strand& strand : strands_)
        for (const Span& span : strand.spans)
            if (std::find(found.begin(), found.end(), span.cover) == found.end())
                found.push_back(span.cover);
    return found;
}

Span ArrowStrands::stretch_of(const Cover& cover) const {
    Span stretch{to_, from_, cover};
    for (const Strand& strand : strands_)
        for (const Span& span : strand.spans)
            if (span.cover == cover) {
                stretch.from = std::min(stretch.from, std::max(span.from, from_));
                stretch.to = std::max(stretch.to, std::min(span.to, to_));
            }
    // Only beyond the ends.
    if (!(stretch.from < stretch.to)) return {from_, to_, cover};
    return stretch;
}

Path ArrowStrands::region_of(const Cover& cover) const {
    Path region;
    for (std::size_t first = 0; first < strands_.size();) {
        // Neighbours with the same sequence of covers: their breaks are on one edge.
        std::size_t end = first + 1;
        while (end < strands_.size() && is_like(strands_[first], strands_[end])) ++end;
        const auto& spans = strands_[first].spans;
        for (std::size_t i = 0; i < spans.size(); ++i) {
            if (!(spans[i].cover == cover)) continue;
            // Round the region; its sides bend where the part begins and ends.
            std::vector<Eigen::Vector2d> edge = edge_of(first, end, i, false);
            const auto add = [&edge](const std::vector<Eigen::Vector2d>& points) {
                edge.insert(edge.end(), points.begin(), points.end());
            };
            add(bends_of(end - 1, i, 1));
            std::vector<Eigen::Vector2d> back = edge_of(first, end, i, true);
            std::reverse(back.begin(), back.end());
            add(back);
            back = bends_of(first, i, -1);
            std::reverse(back.begin(), back.end());
            add(back);
            region.move(edge.front());
            for (std::size_t k = 1; k < edge.size(); ++k) region.line(edge[k]);
            region.close();
        }
        first = end;
    }
    return region;
}

ArrowStrands::Strand ArrowStrands::strand_at(const Canvas& canvas, double side) const {
    Strand strand{side, {}};
    Track track;
    track.flow = [this, side](double s) { return at(side, s); };
    track.knots = {from_ - beyond_, from_, to_, to_ + beyond_};
    if (from_ < to_) strand.spans = canvas.occluders.spans(track, {});
    return strand;
}

// Adds strands between two neighbours until the cut is straight between them, or until they are
// so close that a corner between them is off by no more than that.
void ArrowStrands::refine(const Canvas& canvas, const Strand& one, const Strand& other, int depth) {
    constexpr int deepest = 7;
    constexpr double most_off_pt = 0.01;
    if ((place(other.side, from_) - place(one.side, from_)).norm() <= 2.0 * most_off_pt) return;
    const Strand middle = strand_at(canvas, 0.5 * (one.side + other.side));
    bool is_straight = is_like(one, middle) && is_like(middle, other);
    for (std::size_t i = 0; is_straight && i + 1 < middle.spans.size(); ++i) {
        const Eigen::Vector2d here = place(middle.side, middle.spans[i].to);
        const Eigen::Vector2d a = place(one.side, one.spans[i].to);
        const Eigen::Vector2d chord = place(other.side, other.spans[i].to) - a;
        is_straight = std::abs(cross(chord, here - a)) <= most_off_pt * chord.norm();
    }
    if (is_straight || depth == deepest) return;
    refine(canvas, one, middle, depth + 1);
    strands_.push_back(middle);
    refine(canvas, middle, other, depth + 1);
}

// A point of the near surface. In the head, the radius decreases towards the tip; beyond the
// ends it is constant.
CurveFlow ArrowStrands::at(double side, double s) const {
    const Eigen::Vector3d run = shape_.tip - shape_.tail;
    Eigen::Vector3d off = Eigen::Vector3d::Zero();
    if (!shape_.to_front.isZero(0.0)) {
        const Eigen::Vector3d front = shape_.to_front.normalized();
        off = side * front.cross(shape_.axis) + std::sqrt(1.0 - side * side) * front;
    }
    if (part_ == ArrowPart::shaft) return {shape_.tail + s * run + shape_.shaft_radius * off, run};
    const double length = std::max(to_ - from_, 1e-12);
    const Eigen::Vector3d base = shape_.head_radius * off;
    const double share = std::clamp((to_ - s) / length, 0.0, 1.0);
    const bool narrows = from_ <= s && s <= to_;
    return {shape_.tail + s * run + share * base, narrows ? (run - base / length).eval() : run};
}

bool ArrowStrands::is_like(const Strand& a, const Strand& b) {
    return std::equal(a.spans.begin(), a.spans.end(), b.spans.begin(), b.spans.end(),
                      [](const Span& x, const Span& y) { return x.cover == y.cover; });
}

Eigen::Vector2d ArrowStrands::place(double side, double s) const {
    return projection_.place(at(side, s).position);
}

// A point of the border of strand k towards a neighbour (step 1 or −1): half-way between both,
// or beyond the side of the part.
Eigen::Vector2d ArrowStrands::border(std::size_t k, std::ptrdiff_t step, double s) const {
    const Eigen::Vector2d here = place(strands_[k].side, s);
    const auto next = static_cast<std::ptrdiff_t>(k) + step;
    if (next >= 0 && next < static_cast<std::ptrdiff_t>(strands_.size()))
        return 0.5 * (here + place(strands_[static_cast<std::size_t>(next)].side, s));
    // Sides towards which the strands are numbered.
    const Eigen::Vector2d across = place(1.0, from_) - place(-1.0, from_);
    const double length = across.norm();
    const Eigen::Vector2d out = length > 1e-9 ? (across / length).eval() : shape_.across;
    return here + static_cast<double>(step) * shape_.reach_pt(part_) * out;
}

// The points inside span i at which that border bends.
std::vector<Eigen::Vector2d> ArrowStrands::bends_of(std::size_t k, std::size_t i,
                                                    std::ptrdiff_t step) const {
    std::vector<Eigen::Vector2d> bends;
    const Span& span = strands_[k].spans[i];
    for (const double s : {from_, to_})
        if (span.from < s && s < span.to) bends.push_back(border(k, step, s));
    return bends;
}

// One end of span i of the strands [first, end), continued to the middle between them and their
// neighbours, and beyond the sides and the ends of the part.
std::vector<Eigen::Vector2d> ArrowStrands::edge_of(std::size_t first, std::size_t end,
                                                   std::size_t i, bool at_end) const {
    const double reach = shape_.reach_pt(part_);
    const auto end_at = [&](std::size_t k) {
        const Span& span = strands_[k].spans[i];
        return at_end ? span.to : span.from;
    };
    std::vector<Eigen::Vector2d> edge;
    const auto add = [&](const Eigen::Vector2d& point, double s) {
        double ahead = 0.0;
        if (at_end && s >= to_ + beyond_) ahead = reach;
        if (!at_end && s <= from_ - beyond_) ahead = -reach;
        edge.push_back(point + ahead * shape_.along);
    };
    const auto add_border = [&](std::size_t k, std::ptrdiff_t step) {
        add(border(k, step, end_at(k)), end_at(k));
    };
    add_border(first, -1);
    for (std::size_t k = first; k < end; ++k) add(place(strands_[k].side, end_at(k)), end_at(k));
    add_border(end - 1, 1);
    return edge;
}

}  // namespace poinsot::vector
