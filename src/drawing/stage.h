// (Scene, Motion) → Drawing at any instant. Prepares everything that all instants share.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/type/least_sizes.h"
#include "mechanics/motion.h"
#include "scene/film_clock.h"
#include "scene/scene.h"
#include "shapes/arrow_separation.h"
#include "shapes/views.h"

namespace poinsot {

struct EvaluationCounts;
struct StageData;

// The size and the times of a drawing.
struct StageOptions {
    int width_px = 1920;
    int height_px = 1080;
    int samples = 1;          // samples × samples rendered pixels form one final pixel
    double line_scale = 0.0;  // pixels for a line of "one pixel at 1080 rows"; 0: height_px / 1080
    double curve_px = 0.0;    // what polylines may leave their curves by; 0: as the scene needs
    LeastSizes least{};       // on paper, of the picture drawn
    double first_time_s = 0.0;  // the instants that are drawn lie between these; histories begin
    double last_time_s = 0.0;   // with the first and are made up to the last
    std::optional<double> first_shown_s{};  // no instant before it is drawn; else the first
    double loop_s = 0.0;  // after which the picture is the same again, seconds of motion; 0:
                          // it never is
};

// Holds the geometry that all video frames share and makes the drawing of an instant. Immutable
// once constructed; drawings refer to it and must not outlive it. Move-only.
class Stage {
 public:
    // Throws InputError for a scene without a picture (no invariable plane, unknown element).
    // `beside`: the same motion by another method, drawn as a ghost; both must outlive the stage.
    Stage(const Scene& scene, const Motion& motion, const StageOptions& options,
          const Motion* comparison = nullptr);
    ~Stage();
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;

    // The drawing of an instant, at the film time of this instant.
    Drawing at(double time_s) const;
    Drawing at(const FilmTime& moment) const;

    // The arrows of all panels at an instant, without the rest of the drawing.
    std::vector<PlacedArrow> arrows_at(const FilmTime& moment) const;

    // Evaluations of the motion since the construction of the stage, which is included.
    const EvaluationCounts& counts() const;

    // The largest measured distance of a polyline from its curve, in pixels.
    double curve_error_px() const;

    // What is drawn otherwise than the scene says, and why: one line each.
    std::span<const std::string> notes() const;

    const StageData& data() const { return *data_; }

 private:
    std::unique_ptr<StageData> data_;
};

}  // namespace poinsot
