// A film in slides: where it stops, and what each slide shows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "production/session/film_plan.h"
#include "scene/scene.h"

namespace poinsot {

// A slide plays its frames and stops at the last one, which is the first frame of the next slide.
struct Slide {
    std::string title{}, note{};  // of the stop; after the last stop, of that one
    std::int64_t first_frame = 0, last_frame = 0;
    // The slide repeats this many frames before it goes on; they end with the last one. 0: it
    // stands still.
    std::int64_t n_loop_frames = 0;
    bool is_stop = true;  // false: the frames after the last stop, up to the film's end

    std::int64_t first_loop_frame() const { return last_frame + 1 - n_loop_frames; }
};

// A slide for each of [[stops]]; without stops, for each chapter, which stops before its title and
// captions fade out. `option` is the option that asks for slides, for messages. Throws SceneError
// for two stops on one frame, and for a scene with neither stops nor chapters.
std::vector<Slide> slides_of(const Scene& scene, const FilmPlan& film, std::string_view option);

// The same without the frames after the last stop.
std::vector<Slide> stops_of(const Scene& scene, const FilmPlan& film, std::string_view option);

}  // namespace poinsot
