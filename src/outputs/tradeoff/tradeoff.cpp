#include "tradeoff/tradeoff.h"

namespace poinsot {

Tradeoff trade(const Session& session, const ContextChoice& choice) {
    const FilmPlan film = film_plan(session);
    Tradeoff trades;
    trades.motion = trade_motion(session, film, session.accuracy.px_per_rad);
    trades.picture = trade_picture(session, choice, film);
    trades.film = trade_film(session, choice, film);
    return trades;
}

}  // namespace poinsot
