// (Scene, Motion) → Drawing at any instant. Prepares everything that all instants share.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drawing/stage/stage_options.h"
#include "mechanics/motion.h"
#include "scene/film_clock.h"
#include "scene/scene.h"
#include "shapes/arrow_separation.h"
#include "shapes/camera.h"
#include "shapes/views.h"
#include "typeset/font_source.h"

namespace poinsot {

struct EvaluationCounts;
struct Panel;
struct StageContext;
struct Theme;
class StageStore;

// Returns what replaces the camera that a panel has at an instant.
using CameraChange = std::function<Camera(const Camera& camera)>;

// Holds the geometry that all video frames share and makes the drawing of an instant. Immutable
// once constructed; drawings refer to it and must not outlive it. Move-only.
class Stage {
 public:
    // Throws InputError for a scene without a picture (no invariable plane, unknown element).
    // `theme`: the scene's, from theme_of. `comparison`: the same motion by another method, drawn
    // as a ghost. Both motions must outlive the stage.
    Stage(const Scene& scene, const Theme& theme, const Motion& motion, const StageOptions& options,
          const Motion* comparison = nullptr);
    ~Stage();
    Stage(Stage&&) noexcept;
    Stage& operator=(Stage&&) noexcept;

    // The drawing of an instant, at the film time of this instant.
    Drawing at(double time_s) const;
    // `cameras`: changes of the panels' cameras, for viewers who turn them; labels are laid out for
    // the changed ones. Empty, or an empty function: the scene's own.
    Drawing at(const FilmTime& moment, std::span<const CameraChange> cameras = {}) const;

    // The arrows of all panels at an instant, without the rest of the drawing.
    std::vector<PlacedArrow> arrows_at(const FilmTime& moment) const;

    // The quantities of an instant that all panels together read.
    const Quantities& needs() const;

    // Evaluations of the motion since the construction of the stage, which is included.
    const EvaluationCounts& counts() const;

    // The largest measured distance of a polyline from its curve, in pixels.
    double curve_error_px() const;

    // One line for each difference between the picture and the scene, with its reason.
    std::span<const std::string> notes() const;

    // Its inputs, what all instants share, and its panels.
    const StageContext& context() const;
    const StageStore& store() const;
    const std::deque<Panel>& panels() const;

 private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace poinsot
