// The shape of an arrow on paper: its shaft and its head, between circles about its axis.
#pragma once

#include <Eigen/Core>

#include "vector/canvas.h"

namespace poinsot::vector {

// The parts of an arrow; each is cut and filled on its own.
enum class ArrowPart { shaft, head };

// The shape of an arrow: sizes in units of the view, positions on paper.
struct ArrowShape {
    bool seen = false;
    Eigen::Vector3d axis, tail, neck, tip;
    double shaft_radius = 0.0, head_radius = 0.0;
    Eigen::Vector2d tail_pt, neck_pt, tip_pt;
    double tail_scale = 1.0, neck_scale = 1.0;  // points per unit
    double open = 0.0;                          // minor over major axis of the ellipses as which
                                                // circles about the axis appear
    Eigen::Vector2d along, across;              // on paper, unit vectors
    // The vector from the axis to the line of the shaft's surface nearest to the eye, and the share
    // of the axis up to which it runs parallel to the axis. Colours are computed on this line.
    Eigen::Vector3d to_front = Eigen::Vector3d::Zero();
    double neck_at = 1.0;  // share of the axis

    // The point of this line at a share s of the axis; in the head it approaches the axis.
    Eigen::Vector3d front(double s) const {
        const double rest = s <= neck_at ? 1.0 : (1.0 - s) / (1.0 - neck_at);
        return tail + s * (tip - tail) + rest * to_front;
    }

    // The share of the axis at which a part begins and ends.
    double begin_of(ArrowPart part) const;
    double end_of(ArrowPart part) const;
    // The largest distance of a part's ends beyond the ends of its axis, and of its sides from the
    // axis.
    double reach_pt(ArrowPart part) const;
    // The outline of a part.
    Path outline_of(ArrowPart part) const;
    // A strip across a part that contains everything beside a stretch of its axis.
    Path strip(const Projection& projection, ArrowPart part, double from, double to) const;

 private:
    PaperEllipse circle_about(const Eigen::Vector2d& middle, double radius_pt) const;
    Path hull(const Eigen::Vector2d& a, double radius_a, const Eigen::Vector2d& b,
              double radius_b) const;
};

// Not seen: an arrow without length or opacity, or one that reaches behind the eye.
ArrowShape arrow_shape(const Canvas& canvas, const Arrow& arrow);

}  // namespace poinsot::vector
