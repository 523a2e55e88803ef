// The inputs of a stage, and values that follow from them: the scene, its motion, the
// construction's picture, the theme, sizes and times. Complete before the first panel is made;
// panels, elements and drawers read it; it does not change.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "drawing/stage/construction_picture.h"
#include "drawing/stage/drawer.h"
#include "drawing/stage/stage_options.h"
#include "drawing/stage/timeline.h"
#include "drawing/stage/type/type_sizes.h"
#include "drawing/style/theme.h"
#include "mechanics/counted_motion.h"
#include "scene/film_clock.h"
#include "scene/scene.h"

namespace poinsot {

struct StageContext {
    Scene scene;
    CountedMotion motion;
    std::optional<CountedMotion> comparison;  // by the scene's second method
    StageOptions options;
    Theme theme;                // the scene's theme, with its [style]
    double px = 1.0;            // pixels of the picture for one pixel at 1080 rows
    double curve_px = 0.05;     // largest distance of polylines from their curves
    double film_first_s = 0.0;  // time span of the film and of time axes
    double film_last_s = 1.0;

    std::optional<ConstructionPicture> rolling;  // of motions that rotate without a driving torque
    std::optional<double> polhode_period_s;      // if it has one
    double turn_rate_rad_s = 0.0;  // of the shown space axes about L (co-precessing camera)
    Timeline timeline;

    // Both motions must outlive it; `comparison`: null for none.
    StageContext(const Scene& scene, const Theme& theme, const Motion& motion,
                 const StageOptions& options, const Motion* comparison);
    StageContext(const StageContext&) = delete;
    StageContext& operator=(const StageContext&) = delete;

    // The nearest boundary between final pixels: a shape placed there does not move with the number
    // of samples per pixel.
    double at_whole_pixel(double at_px) const {
        return options.samples * std::round(at_px / options.samples);
    }

    // The state at an instant, with only these quantities; attitude and herpolhode in the shown
    // space axes. `with_comparison`: also that of the comparison motion.
    FrameInput instant_at(const FilmTime& moment, const Quantities& needs,
                          bool with_comparison) const;

    // The state of a row of the scene's measured motion, in space axes; the attitude is the exact
    // one if the table has none.
    RotationState measured_state(const MeasuredRow& row) const;

    // Rotation from space axes to the shown axes. For a co-precessing camera, the camera, its light
    // and its view of the plane turn about L together; this equals a fixed camera and
    // rotating space axes. Both axes coincide at the film's start.
    bool turns() const { return turn_rate_rad_s != 0.0; }
    // Under drag the shown axes turn with L, by the least turn that takes its direction to that at
    // the start.
    bool follows_momentum() const { return rolling && rolling->is_slowed; }
    Eigen::Quaterniond turned_from_space(double time_s) const;

    // An upper bound of |ω|, rad/s: from the energy at the start and the work of gravity.
    double quickest_rate_rad_s() const;

 private:
    void make_construction();
    void check_turning() const;
    void widen_herpolhode();
    Eigen::Quaterniond turn_of_momentum(const RotationState& state) const;
};

// The least em size of text, in pixels of the rendered picture: in a film 1/45 of its height; on
// paper the value of the stage's options.
double least_type_px(const StageContext& stage);

// Pixels of the rendered picture for a point on paper, or 1/540 of a slide's height.
double px_per_pt(const StageContext& stage);

// On paper all text has sizes in points, the same in every panel: titles are larger than headings,
// these than names, and these than numbers. Whether the stage is on paper:
inline bool is_on_paper(const StageContext& stage) { return stage.options.least.type_px > 0.0; }
inline double paper_type_px(const StageContext& stage) {
    return paper_type_px(stage.scene, stage.px, stage.options.least);
}
// The sizes of its text.
inline const TypeSizes& type_sizes(const StageContext& stage) {
    return is_on_paper(stage) ? paper_sizes : screen_sizes;
}

}  // namespace poinsot
