// Plans the sides of names over a film.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "drawing/stage/thing_names.h"
#include "drawing/stage/type/name_places.h"

namespace poinsot {

namespace {

// Costs a second of film of a name's places, and of changes between them: a name that would stay
// for a second or two is not worth its coming and going.
constexpr double greatest_cost = 6.0;
constexpr double cost_of_coming = 2.5, cost_of_change = 6.0;
constexpr double least_stay_s = 2.0;

constexpr int absent = n_name_sides;  // the state after those of the sides

// The states of least total cost over the instants, by dynamic programming. `costs`: of all states
// at each instant, per second; `comes_free`: whether the name may come and go without cost before
// an instant.
std::vector<int> cheapest_states(const std::vector<std::vector<double>>& costs,
                                 const std::vector<bool>& comes_free, double step_s) {
    std::vector<double> sums(n_name_sides + 1, 0.0);
    std::vector<std::vector<int>> from(costs.size(), std::vector<int>(n_name_sides + 1, 0));
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const auto best = std::min_element(sums.begin(), sums.begin() + n_name_sides);
        const int best_side = static_cast<int>(best - sums.begin());
        const double change = k == 0 ? 0.0 : cost_of_change;
        const double coming = k == 0 || comes_free[k] ? 0.0 : cost_of_coming;
        std::vector<double> next(n_name_sides + 1);
        for (int s = 0; s <= n_name_sides; ++s) {
            const auto i = static_cast<std::size_t>(s);
            double least = sums[i];
            int before = s;
            const auto look_at = [&](int state, double with) {
                const double sum = sums[static_cast<std::size_t>(state)] + with;
                if (sum < least) {
                    least = sum;
                    before = state;
                }
            };
            if (s != absent) look_at(absent, coming);
            look_at(best_side, s == absent ? coming : change);
            next[i] = least + step_s * costs[k][i];
            from[k][i] = before;
        }
        sums = std::move(next);
    }
    std::vector<int> states(costs.size());
    int state = static_cast<int>(std::min_element(sums.begin(), sums.end()) - sums.begin());
    for (std::size_t k = costs.size(); k-- > 0;) {
        states[k] = state;
        state = from[k][static_cast<std::size_t>(state)];
    }
    return states;
}

// Removes stays that are too short to be read.
void drop_short_stays(double step_s, std::vector<int>& states) {
    for (std::size_t first = 0; first < states.size();) {
        std::size_t end = first;
        while (end < states.size() && (states[end] == absent) == (states[first] == absent)) ++end;
        const bool is_whole = first == 0 && end == states.size();
        if (states[first] != absent && !is_whole &&
            step_s * static_cast<double>(end - first) < least_stay_s)
            std::fill(states.begin() + static_cast<std::ptrdiff_t>(first),
                      states.begin() + static_cast<std::ptrdiff_t>(end), absent);
        first = end;
    }
}

// Plans the states within the loop of a stop anew, with the same one at both ends: the picture of
// the stop is followed by that of the loop's beginning.
void close_loop(const FilmLoop& loop, const std::vector<double>& film_s,
                const std::vector<std::vector<double>>& costs, const std::vector<bool>& comes_free,
                double step_s, std::vector<int>& states) {
    const auto first = std::lower_bound(film_s.begin(), film_s.end(), loop.begin_s);
    const auto end = std::lower_bound(first, film_s.end(), loop.end_s);
    if (first == end) return;
    const auto from = first - film_s.begin(), to = end - film_s.begin();
    if (states[static_cast<std::size_t>(from)] == states[static_cast<std::size_t>(to - 1)]) return;
    const std::vector<std::vector<double>> within(costs.begin() + from, costs.begin() + to);
    const std::vector<bool> free_within(comes_free.begin() + from, comes_free.begin() + to);
    constexpr double forbidden = 1e9;
    double least = std::numeric_limits<double>::infinity();
    for (int s = 0; s <= n_name_sides; ++s) {
        std::vector<std::vector<double>> held = within;
        for (std::vector<double>* ends : {&held.front(), &held.back()})
            for (std::size_t other = 0; other < ends->size(); ++other)
                if (other != static_cast<std::size_t>(s)) (*ends)[other] += forbidden;
        const std::vector<int> tried = cheapest_states(held, free_within, step_s);
        double sum = 0.0;
        for (std::size_t k = 0; k < tried.size(); ++k) {
            sum += step_s * held[k][static_cast<std::size_t>(tried[k])];
            if (k > 0 && tried[k] != tried[k - 1]) sum += cost_of_change;
        }
        if (sum >= least) continue;
        least = sum;
        std::copy(tried.begin(), tried.end(), states.begin() + from);
    }
}

// The second of the film at which a name changes between two instants of the plan: halfway, but not
// while the loop of a stop begins or ends.
double change_between(double before_s, double after_s, const std::vector<FilmLoop>& loops) {
    for (const FilmLoop& loop : loops) {
        if (before_s < loop.begin_s && loop.begin_s <= after_s) return loop.begin_s - name_fade_s;
        if (before_s < loop.end_s && loop.end_s <= after_s) return loop.end_s + name_fade_s;
    }
    return 0.5 * (before_s + after_s);
}

// The spans of states at evenly spaced instants.
std::vector<NameSpan> spans_of(const std::vector<int>& states, const std::vector<double>& film_s,
                               const std::vector<FilmLoop>& loops) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<NameSpan> spans;
    for (std::size_t first = 0; first < states.size();) {
        std::size_t end = first;
        while (end < states.size() && states[end] == states[first]) ++end;
        if (states[first] != absent)
            spans.push_back(
                {first == 0 ? -infinite : change_between(film_s[first - 1], film_s[first], loops),
                 end == states.size() ? infinite
                                      : change_between(film_s[end - 1], film_s[end], loops),
                 side_of(states[first])});
        first = end;
    }
    // A name that changes its side appears on the new one while it fades on the old one.
    for (std::size_t k = 1; k < spans.size(); ++k)
        if (spans[k].begin_s <= spans[k - 1].end_s) {
            spans[k].begin_s -= 0.5 * name_fade_s;
            spans[k - 1].end_s += 0.5 * name_fade_s;
        }
    return spans;
}

}  // namespace

void plan_names(const Panel& panel, std::vector<PlacedLabels> instants, bool is_loop,
                const std::vector<FilmLoop>& loops, std::vector<ThingName>& names) {
    const std::size_t n = instants.size();
    const double step_s = instants[1].film_s - instants[0].film_s;
    std::vector<double> film_s;
    std::vector<Surroundings> around;
    for (const PlacedLabels& instant : instants) {
        film_s.push_back(instant.film_s);
        around.push_back(surroundings_of(*instant.view, instant.taken, name_margin_px(panel)));
    }
    for (ThingName& name : names) {
        name.spans.emplace();
        if (name.type.mask->width == 0) continue;
        std::vector<std::vector<double>> costs(n, std::vector<double>(n_name_sides + 1, 0.0));
        std::vector<bool> is_shown(n), comes_free(n);
        std::vector<Spots> spots;
        spots.reserve(n);
        for (std::size_t k = 0; k < n; ++k) {
            spots.emplace_back(*instants[k].view, name);
            is_shown[k] = seen_share(spots[k]) >= 0.5;
            costs[k][absent] = is_shown[k] ? most_cost_of(*name.thing) : 0.0;
            for (int s = 0; s < n_name_sides; ++s) {
                const NameSide side = side_of(s);
                const auto spot =
                    is_shown[k] ? spots[k].at(side.angle_rad, side.level) : std::nullopt;
                costs[k][static_cast<std::size_t>(s)] =
                    spot ? std::min(greatest_cost,
                                    room_cost(*spot, *name.thing, around[k], name.em_px) +
                                        preference_cost(*name.thing, side))
                         : greatest_cost;
            }
        }
        if (std::find(is_shown.begin(), is_shown.end(), true) == is_shown.end()) continue;
        for (std::size_t k = 0; k < n; ++k)
            comes_free[k] = is_shown[k] != is_shown[k > 0 ? k - 1 : n - 1];
        // A loop is planned as the middle one of three, so that it has no seam.
        std::vector<int> states;
        if (is_loop) {
            std::vector<std::vector<double>> thrice;
            std::vector<bool> free_thrice;
            for (int turn = 0; turn < 3; ++turn) {
                thrice.insert(thrice.end(), costs.begin(), costs.end());
                free_thrice.insert(free_thrice.end(), comes_free.begin(), comes_free.end());
            }
            states = cheapest_states(thrice, free_thrice, step_s);
            states = {states.begin() + static_cast<std::ptrdiff_t>(n),
                      states.begin() + static_cast<std::ptrdiff_t>(2 * n)};
        } else {
            states = cheapest_states(costs, comes_free, step_s);
        }
        drop_short_stays(step_s, states);
        for (const FilmLoop& loop : loops)
            close_loop(loop, film_s, costs, comes_free, step_s, states);
        name.spans = spans_of(states, film_s, loops);
        if (is_loop && states.front() != states.back()) {
            // A change at the seam.
            if (states.front() != absent)
                name.spans->front().begin_s = film_s.front() - 0.5 * step_s;
            if (states.back() != absent) name.spans->back().end_s = film_s.back() + 0.5 * step_s;
        }
        // The names after it keep off it.
        for (std::size_t k = 0; k < n; ++k) {
            if (states[k] == absent) continue;
            const NameSide side = side_of(states[k]);
            if (const auto spot = spots[k].at(side.angle_rad, side.level))
                around[k].labels.push_back({spot->box.centre_px, spot->box.half_px, 1.0});
        }
    }
}

}  // namespace poinsot
