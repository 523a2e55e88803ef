#include "lab/tradeoff.h"

#include "drawing/reach.h"

namespace poinsot {

Tradeoff trade(const Session& session, const ContextChoice& choice) {
    const FilmPlan film = film_plan(session);
    Tradeoff trades;
    trades.motion = trade_motion(session, film, pixels_per_radian(session.scene));
    trades.picture = trade_picture(session, choice, film);
    trades.film = trade_film(session, choice, film);
    return trades;
}

}  // namespace poinsot
