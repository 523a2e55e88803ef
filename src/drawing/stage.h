// (Scene, Motion) → Drawing at any instant: everything that can be made once is made here.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drawing/type/least_sizes.h"
#include "mechanics/motion.h"
#include "scene/film_clock.h"
#include "scene/scene.h"
#include "shapes/views.h"

namespace poinsot {

struct EvaluationCounts;
struct StageData;

// What is drawn and at what size.
struct StageOptions {
    int width_px = 1920;
    int height_px = 1080;
    int samples = 1;          // of these a side go into one pixel of the picture that is looked at
    double line_scale = 0.0;  // pixels for a line of "one pixel at 1080 rows"; 0: height_px / 1080
    double curve_px = 0.0;    // what polylines may leave their curves by; 0: as the scene asks
    LeastSizes least{};       // on paper, of the picture drawn
    double first_time_s = 0.0;  // the instants that are drawn lie between these; histories begin
    double last_time_s = 0.0;   // with the first and are made up to the last
    std::optional<double> first_shown_s{};  // no instant before it is drawn; else the first
    double loop_s = 0.0;  // after which the picture is the same again, seconds of motion; 0:
                          // it never is
};

// Holds the geometry that all video frames share and makes the drawing of an instant. Immutable
// once made; drawings refer to it and must not outlive it. Move-only.
class Stage {
 public:
    // Throws InputError for a scene that has no picture (no invariable plane, unknown element).
    // `beside`: the same motion by another method, drawn as a ghost; both must outlive the stage.
    Stage(const Scene& scene, const Motion& motion, const StageOptions& options,
          const Motion* beside = nullptr);
    ~Stage();
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;

    // The second of the film is the one that its clock names for this instant.
    Drawing at(double time_s) const;
    Drawing at(const FilmMoment& moment) const;

    // What has been asked of the motion since the stage was made, its making included.
    const EvaluationCounts& counts() const;

    // The greatest distance, in pixels, of a curve's polyline from the curve, where it was
    // measured.
    double curve_error_px() const;

    // What is drawn otherwise than the scene says, and why: one line each.
    std::span<const std::string> notes() const;

    const StageData& data() const { return *data_; }

 private:
    std::unique_ptr<StageData> data_;
};

}  // namespace poinsot
