#include "production/session/still_moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drawing/stage/stage.h"
#include "error/error.h"
#include "shapes/arrow_separation.h"

namespace poinsot {

FilmTime still_moment(const Session& session, const std::optional<double>& time_s, StillTime when) {
    const FilmPlan film = film_plan(session);
    // An instant for which the motion fails is reported with its option.
    if (time_s) {
        const FilmTime moment = moment_of_time(film.clock, *time_s);
        try {
            session.motion.at(moment.time_s);
        } catch (const InputError& error) {
            throw InputError(fmt::format("--time {}: {}", *time_s, error.what()));
        }
        return moment;
    }
    const std::optional<double> own_s =
        when == StillTime::clearest ? std::nullopt : session.scene.film.still_s;
    return at_key_of_error(session.scene, "motion", own_s ? "film.still_s" : "film", [&] {
        const FilmTime moment = own_s                       ? moment_of_time(film.clock, *own_s)
                                : when == StillTime::common ? film.moment_of(film.n_frames - 1)
                                                            : clearest_moment(session);
        session.motion.at(moment.time_s);
        return moment;
    });
}

FilmTime clearest_moment(const Session& session) {
    constexpr std::int64_t most_looks = 64;
    // At 1080 rows. Arrows this far apart are clearly separate, including their labels.
    constexpr double step_px = 1.0;
    constexpr double enough_px = 40.0;
    const FilmPlan film = film_plan(session);
    const std::int64_t n_looks = std::min(most_looks, film.n_frames);
    if (n_looks <= 1) return film.moment_of(film.n_frames - 1);

    // Of one shape, so that a picture on a screen and one on paper show the same instant.
    StageOptions options;
    options.width_px = 1920;
    options.height_px = 1080;
    options.first_time_s = film.start_s;
    options.last_time_s = film.last_time_s();
    options.curve_px = 4.0;  // curves are not looked at
    options.repeat_s = film.repeat_s;
    options.fonts = session.fonts;
    const Stage stage(session.scene, session.theme, session.motion, options,
                      session.comparison ? &*session.comparison : nullptr);
    std::vector<FilmTime> moments;
    std::vector<std::vector<PlacedArrow>> pictures;
    for (std::int64_t k = 0; k < n_looks; ++k) {
        moments.push_back(film.moment_of(k * (film.n_frames - 1) / (n_looks - 1)));
        pictures.push_back(stage.arrows_at(moments.back()));
    }
    return moments.at(clearest_picture(pictures, step_px, enough_px));
}

}  // namespace poinsot
