// Divides lines over unevenly lit surfaces into spans of one ink each.
#include <algorithm>
#include <cmath>
#include <utility>

#include "vector/canvas.h"

namespace poinsot::vector {

namespace {

constexpr int n_steps = 48;
constexpr double most_off = 6.0 / 255.0;

// The largest difference of two inks' colours over the same background.
double off_at(const PaperInk& ink, const PaperInk& wanted, const Colour& behind) {
    const Colour is = over(ink, behind), should = over(wanted, behind);
    return std::max(
        {std::abs(is.r - should.r), std::abs(is.g - should.g), std::abs(is.b - should.b)});
}

// The overlap of neighbouring spans, a third of a point, as a parameter.
double overlap(const Canvas& canvas, const Track& track, double at) {
    constexpr double overlap_pt = 0.33;
    const double speed = on_paper(canvas.projection, track.flow(at)).velocity.norm();
    return speed > 0.0 ? overlap_pt / speed : 0.0;
}

using MakeInk = PaperInk (*)(const Colour& colour, double opacity, const Colour& behind);

// Groups consecutive looks that one ink can represent. In the result, from and to are the index of
// the first look and one past the last.
std::vector<Canvas::ConstantColourSpan> runs_of(const std::vector<Canvas::LineLook>& looks,
                                                MakeInk make) {
    std::vector<PaperInk> inks;
    inks.reserve(looks.size());
    for (const Canvas::LineLook& look : looks)
        inks.push_back(make(look.colour, look.opacity, look.behind));
    const auto is_even = [&](std::size_t first, std::size_t end) {
        const PaperInk& ink = inks[(first + end) / 2];
        for (std::size_t k = first; k < end; ++k)
            if (off_at(ink, inks[k], looks[k].behind) > most_off) return false;
        return true;
    };
    std::vector<Canvas::ConstantColourSpan> runs;
    for (std::size_t first = 0; first < looks.size();) {
        std::size_t end = first + 1;
        while (end < looks.size() && is_even(first, end + 1)) ++end;
        runs.push_back(
            {static_cast<double>(first), static_cast<double>(end), inks[(first + end) / 2]});
        first = end;
    }
    return runs;
}

}  // namespace

std::vector<Canvas::ConstantColourSpan> Canvas::constant_colour_spans(
    const Track& track, double from, double to,
    const std::function<LineLook(double)>& look_at) const {
    const double step = (to - from) / n_steps;
    // Sampled at the middles of the steps.
    std::vector<LineLook> looks;
    looks.reserve(n_steps);
    for (int k = 0; k < n_steps; ++k) looks.push_back(look_at(from + (k + 0.5) * step));
    std::vector<ConstantColourSpan> parts = runs_of(looks, as_in_light);
    const bool is_pale = std::all_of(looks.begin(), looks.end(),
                                     [](const LineLook& look) { return look.opacity < 1.0; });
    if (is_pale) {
        std::vector<ConstantColourSpan> shades = runs_of(looks, as_shade);
        if (shades.size() < parts.size()) parts = std::move(shades);
    }

    for (ConstantColourSpan& part : parts) {
        // Few distinct values keep the file small.
        part.ink.alpha = std::round(100.0 * part.ink.alpha) / 100.0;
        const bool is_last = part.to == n_steps;
        part.from = from + part.from * step;
        part.to = is_last ? to : from + part.to * step;
        if (constexpr double nearly_opaque = 0.8; !is_last && part.ink.alpha > nearly_opaque)
            part.to = std::min(part.to + overlap(*this, track, part.to), to);
    }
    return parts;
}

}  // namespace poinsot::vector
