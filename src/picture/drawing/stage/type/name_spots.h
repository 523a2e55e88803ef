// The places at which the name of a thing may be: a direction in the picture, and a level, from 0
// (near) on.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "drawing/stage/type/named_thing.h"
#include "shapes/outlines.h"
#include "shapes/views.h"

namespace poinsot {

// The share of a leader that is drawn over a distance: none where the name is beside its thing, and
// all of it from one and a quarter of the letters' size on.
double leader_share(double away_px, double em_px);

// A place for a name: the point that it names, and the centre of its box.
struct Spot {
    Eigen::Vector3d at;
    Eigen::Vector2d anchor_px;
    LabelBox box;
    double spread_px = 0.0;
    double leader = 0.0;  // how much of a leader is drawn to the box, 0…1
};

class Spots {
 public:
    // The view must outlive it.
    Spots(const View& view, const ThingName& name);

    // Whether the view has the thing, seen or hidden.
    bool is_shown() const { return is_shown_; }
    double opacity() const { return opacity_; }
    bool has_leader() const { return plane_ == nullptr; }
    // The visible point of the thing that is nearest to a box; null if there is none.
    const VisiblePoint* nearest(const LabelBox& box) const;

    std::optional<Spot> at(double angle_rad, double level) const;

 private:
    std::optional<Spot> on_plane(const Eigen::Vector2d& way, double level) const;

    const View& view_;
    Eigen::Vector2d half_;
    double em_px_;
    Outline outline_;
    const Plane* plane_ = nullptr;
    double opacity_ = 0.0;
    bool is_shown_ = false, grows_ = false;
};

}  // namespace poinsot
