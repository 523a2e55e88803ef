#include "vector/sheet_of_paper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poinsot::vector {

namespace {

// Whether a Bézier equals its chord within a nanometre.
bool is_straight(const Bezier& b) {
    constexpr double least_pt = 3e-6;
    const Eigen::Vector2d chord = b[3] - b[0];
    const double length = chord.norm();
    if (!(length > 0.0)) return (b[1] - b[0]).norm() + (b[2] - b[0]).norm() < least_pt;
    const auto off = [&](const Eigen::Vector2d& p) {
        return std::abs(chord.x() * p.y() - chord.y() * p.x()) / length;
    };
    return off(b[1] - b[0]) < least_pt && off(b[2] - b[0]) < least_pt;
}

// The beginning of the clip that ended last.
const ClipBegin& last_ended(const std::vector<Item>& items) {
    int open = 0;
    for (std::size_t k = items.size();; --k) {
        if (std::holds_alternative<ClipEnd>(items[k - 1])) ++open;
        const ClipBegin* begin = std::get_if<ClipBegin>(&items[k - 1]);
        if (begin != nullptr && --open == 0) return *begin;
    }
}

Colour between(const Colour& a, const Colour& b, double t) {
    const double u = 1.0 - t;
    return {u * a.r + t * b.r, u * a.g + t * b.g, u * a.b + t * b.b};
}

}  // namespace

void Path::move(const Eigen::Vector2d& to) {
    steps.emplace_back();
    steps.back().to = to;
}

void Path::line(const Eigen::Vector2d& to) {
    move(to);
    steps.back().kind = Step::Kind::line;
}

void Path::cubic(const Eigen::Vector2d& control_1, const Eigen::Vector2d& control_2,
                 const Eigen::Vector2d& to) {
    move(to);
    steps.back().kind = Step::Kind::cubic;
    steps.back().control_1 = control_1;
    steps.back().control_2 = control_2;
}

void Path::close() {
    steps.emplace_back();
    steps.back().kind = Step::Kind::close;
}

void Path::add(const std::vector<Bezier>& beziers, bool begins) {
    for (const Bezier& bezier : beziers) {
        if (begins) move(bezier[0]);
        begins = false;
        if (is_straight(bezier))
            line(bezier[3]);
        else
            cubic(bezier[1], bezier[2], bezier[3]);
    }
}

void Path::add_rectangle(const Eigen::Vector2d& corner, const Eigen::Vector2d& size) {
    move(corner);
    line(corner + Eigen::Vector2d(size.x(), 0.0));
    line(corner + size);
    line(corner + Eigen::Vector2d(0.0, size.y()));
    close();
}

void Path::add(const Path& other) {
    steps.insert(steps.end(), other.steps.begin(), other.steps.end());
}

void SheetOfPaper::add(Item&& item) {
    const ClipBegin* clip = std::get_if<ClipBegin>(&item);
    if (clip != nullptr && !items.empty() && std::holds_alternative<ClipEnd>(items.back()) &&
        *clip == last_ended(items))
        items.pop_back();
    else if (std::holds_alternative<GroupEnd>(item) && !items.empty() &&
             std::holds_alternative<GroupBegin>(items.back())) {
        --ids[std::get<GroupBegin>(items.back()).id];
        items.pop_back();
    } else
        items.push_back(std::move(item));
}

void SheetOfPaper::begin_group(const std::string& id) {
    std::string unique = id;
    for (int n = 2; ids[unique] > 0; ++n) unique = id + "-" + std::to_string(n);
    ++ids[unique];
    items.emplace_back(GroupBegin{std::move(unique)});
}

void SheetOfPaper::enter_group(const std::string& id) {
    if (id == entered) return;
    if (!entered.empty()) add(GroupEnd{});
    if (!id.empty()) begin_group(id);
    entered = id;
}

double ShadedDisc::radius(int ring) const {
    constexpr double beyond = 1.06;
    return ring == n_rings ? beyond : std::sin(0.5 * std::numbers::pi * ring / n_rings);
}

const Colour& ShadedDisc::at(int ring, int spoke) const {
    const auto at = [](int count) { return static_cast<std::size_t>(count); };
    return colours[at(ring) * at(n_spokes) + at(spoke % n_spokes)];
}

Colour ShadedDisc::at(const Eigen::Vector2d& in_disc) const {
    const double r = in_disc.norm();
    const double rings = std::asin(std::min(r, 1.0)) / (0.5 * std::numbers::pi) * n_rings;
    const int ring = std::min(static_cast<int>(rings), n_rings - 1);
    const double outward =
        std::clamp((r - radius(ring)) / (radius(ring + 1) - radius(ring)), 0.0, 1.0);
    double turns = std::atan2(in_disc.y(), in_disc.x()) / (2.0 * std::numbers::pi);
    if (turns < 0.0) turns += 1.0;
    const double spokes = turns * n_spokes;
    const int spoke = std::min(static_cast<int>(spokes), n_spokes - 1);
    const double round = spokes - spoke;
    return between(between(at(ring, spoke), at(ring, spoke + 1), round),
                   between(at(ring + 1, spoke), at(ring + 1, spoke + 1), round), outward);
}

}  // namespace poinsot::vector
