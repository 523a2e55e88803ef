// The stage of a session's pictures, and the bounds of its errors.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/stage/stage.h"
#include "drawing/stage/stage_context.h"
#include "production/session/print_size.h"
#include "production/session/session.h"
#include "production/session/task.h"

namespace poinsot {

struct PictureSpan {
    double first_time_s = 0.0;
    double last_time_s = 0.0;
    std::optional<double> first_shown_s{};  // no picture is earlier; else the first
    bool is_still = false;                  // as in StageOptions
};

// The span of a whole film.
PictureSpan whole_film(const FilmPlan& film);

// The span of a picture of one instant: histories start with the film. They end at the instant,
// or with the film if the scene wants a trail of the entire film.
PictureSpan span_of_instant(const Session& session, const FilmPlan& film, double time_s);

// Settings of a picture's quality; --quality selects some of these.
struct PictureSetting {
    double curve_tolerance = 1.0;                // factor on half of the scene's accuracy_px
    int samples = 1;                             // supersampling: samples × samples per pixel
    double line_scale = 0.0;                     // as in StageOptions, of the final picture
    double px_per_pt = 0.0;                      // as there
    LeastSizes least{};                          // as in StageOptions, of the final picture
    std::vector<std::optional<Camera>> views{};  // as in StageOptions

    // Uses the sizes of lines and text on paper.
    void put_on(const PrintSize& paper) {
        line_scale = paper.line_scale;
        px_per_pt = paper.px_per_pt;
        least = paper.least;
    }
};

// The settings of the scene's quality, with the size on paper.
PictureSetting setting_of(const Scene& scene, const PrintChoices& print = {});

// The stage of pictures with this setting. The session must outlive it.
Stage stage_of(const Session& session, const PictureSpan& span, const PictureSetting& setting);

// Reports substitutions: curves drawn as a ring, and characters drawn as boxes because no font has
// them.
void tell_stage_notes(const Stage& stage, const Task& task);

// Reports names that are drawn at none of these instants, and why.
void tell_unnamed(const Stage& stage, std::span<const FilmTime> moments, const Task& task);

// Upper bounds of position errors in the picture, in pixels of the final picture.
struct PictureBound {
    double motion_px = 0.0;            // see motion_error_px
    double curves_px = 0.0;            // polylines for curves
    std::vector<std::string> notes{};  // substitutions, see Stage
    double total_px() const { return motion_px + curves_px; }
};
PictureBound bound_of(const Session& session, const Stage& stage, int samples);

// "within 0.05 px of the truth (motion 1.6e-11 px, curves 0.05 px; 0.1 px asked)"
std::string in_words(const PictureBound& bound, double accuracy_px);

// Everything that the pictures of a session need except for the context. Preparing it takes most of
// the time of a small picture, and may be done by another thread. The session must outlive it.
struct PreparedPicture {
    // With the settings of the scene's quality.
    PreparedPicture(const Session& session, const PictureSpan& span, const PrintChoices& print);
    PreparedPicture(const Session& session, const PictureSpan& span, const PictureSetting& setting);

    int samples;
    Stage stage;
    PictureBound bound;
};

}  // namespace poinsot
