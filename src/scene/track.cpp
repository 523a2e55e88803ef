#include "scene/track.h"

#include <algorithm>

namespace poinsot {

Track::Track(double value) : keys_{{0.0, value, &easings().front(), 0.0}} {}

void Track::add(double at_s, double value, const Easing& easing) {
    if (at_s <= keys_.back().at_s) {
        keys_.back().value = value;
        keys_.back().easing = &easing;
        return;
    }
    const double until_here = integral(at_s);
    const Key& before = keys_.back();
    const double length_s = at_s - before.at_s;
    const double change = (value - before.value) * length_s * easing.integral(1.0);
    keys_.push_back({at_s, value, &easing, until_here + change});
}

const Track::Key* Track::key_before(double film_s) const {
    const auto after =
        std::upper_bound(keys_.begin(), keys_.end(), film_s,
                         [](double instant, const Key& key) { return instant < key.at_s; });
    return after == keys_.begin() ? keys_.data() : &*(after - 1);
}

double Track::at(double film_s) const {
    const Key* from = key_before(film_s);
    if (from == &keys_.back() || film_s <= from->at_s) return from->value;
    const Key* to = from + 1;
    const double u = (film_s - from->at_s) / (to->at_s - from->at_s);
    return from->value + (to->value - from->value) * to->easing->value(u);
}

double Track::integral(double film_s) const {
    const Key* from = key_before(film_s);
    const double since_s = film_s - from->at_s;
    const double steady = from->integral + from->value * since_s;
    if (from == &keys_.back() || since_s <= 0.0) return steady;
    const Key* to = from + 1;
    const double length_s = to->at_s - from->at_s;
    return steady + (to->value - from->value) * length_s * to->easing->integral(since_s / length_s);
}

bool Track::moves() const { return least() < greatest(); }

double Track::least() const {
    return std::min_element(keys_.begin(), keys_.end(),
                            [](const Key& a, const Key& b) { return a.value < b.value; })
        ->value;
}

double Track::greatest() const {
    return std::max_element(keys_.begin(), keys_.end(),
                            [](const Key& a, const Key& b) { return a.value < b.value; })
        ->value;
}

}  // namespace poinsot
