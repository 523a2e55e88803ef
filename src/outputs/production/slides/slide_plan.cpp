#include "production/slides/slide_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/stage/overlay.h"
#include "production/films/chapters.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

std::vector<Slide> from_stops(const Scene& scene, const FilmPlan& film) {
    std::vector<Slide> slides;
    for (std::size_t i = 0; i < scene.stops.size(); ++i) {
        const StopSpec& stop = scene.stops[i];
        Slide slide{.title = stop.title, .note = stop.note};
        slide.first_frame = slides.empty() ? 0 : slides.back().last_frame;
        slide.last_frame = std::min(film.frame_at(stop.at_s), film.n_frames - 1);
        // At the film's end; elsewhere stops are at least a frame apart.
        if (!slides.empty() && slide.last_frame == slides.back().last_frame)
            throw SceneError(
                scene.location_of(fmt::format("stops[{}].at_s", i)),
                fmt::format("stops[{}] and stops[{}] are both at the film's last frame, which is "
                            "shown at {:.6g} s; remove one of them",
                            i - 1, i, film.moment_of(slide.last_frame).film_s));
        if (stop.loop_s)
            slide.n_loop_frames = std::clamp<std::int64_t>(
                std::llround(*stop.loop_s * film.rate.per_second()), 1, slide.last_frame + 1);
        slides.push_back(std::move(slide));
    }
    return slides;
}

std::vector<Slide> from_chapters(const Scene& scene, const FilmPlan& film) {
    std::vector<Slide> slides;
    for (const FilmChapter& chapter : chapters_of(scene, film, 0, film.n_frames - 1)) {
        Slide slide{.title = chapter.title};
        slide.first_frame = slides.empty() ? 0 : slides.back().last_frame;
        // Before the chapter's title and captions fade out.
        const double fps = film.rate.per_second();
        const auto n_fading = static_cast<std::int64_t>(
            std::ceil(fps * text_fade_s(static_cast<double>(chapter.first_frame) / fps,
                                        static_cast<double>(chapter.end_frame) / fps)));
        slide.last_frame = std::max(chapter.end_frame - 1 - n_fading, chapter.first_frame);
        slides.push_back(std::move(slide));
    }
    return slides;
}

}  // namespace

std::vector<Slide> stops_of(const Scene& scene, const FilmPlan& film, std::string_view option) {
    if (scene.stops.empty() && scene.chapters.empty())
        throw SceneError(scene.location_of("stops"),
                         fmt::format("the scene has no [[stops]] and no [[chapters]] for {0}; add "
                                     "[[stops]] with at_s, or leave {0} out",
                                     option));
    return scene.stops.empty() ? from_chapters(scene, film) : from_stops(scene, film);
}

std::vector<Slide> slides_of(const Scene& scene, const FilmPlan& film, std::string_view option) {
    std::vector<Slide> slides = stops_of(scene, film, option);
    const std::int64_t last = slides.back().last_frame;
    if (!scene.stops.empty() && last < film.n_frames - 1)
        slides.push_back({.title = slides.back().title,
                          .note = slides.back().note,
                          .first_frame = last,
                          .last_frame = film.n_frames - 1,
                          .is_stop = false});
    return slides;
}

}  // namespace poinsot
