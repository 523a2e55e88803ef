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
    pass_through(keys_.size() - 2);
}

bool Track::is_cubic(const Key& from, const Key& to) {
    return to.easing->goes_on || from.velocity != 0.0;
}

// Sets the velocity at a key that now has a key after it, and the values that depend on it. A
// weighted harmonic mean of the slopes to both sides, it is 0 where they differ in sign.
void Track::pass_through(std::size_t key) {
    const bool arrives_at_rest = keys_[key + 1].easing->value(0.5) >= 0.5;
    if (key > 0 && keys_[key].easing->goes_on && arrives_at_rest) {
        const Key& before = keys_[key - 1];
        const Key& after = keys_[key + 1];
        const double h0 = keys_[key].at_s - before.at_s;
        const double h1 = after.at_s - keys_[key].at_s;
        const double slope0 = (keys_[key].value - before.value) / h0;
        const double slope1 = (after.value - keys_[key].value) / h1;
        if (slope0 * slope1 > 0.0) {
            const double w0 = 2.0 * h1 + h0;
            const double w1 = h1 + 2.0 * h0;
            keys_[key].velocity = (w0 + w1) / (w0 / slope0 + w1 / slope1);
        }
    }
    for (std::size_t k = std::max<std::size_t>(key, 1); k < keys_.size(); ++k) {
        const Key& from = keys_[k - 1];
        if (!is_cubic(from, keys_[k])) continue;
        keys_[k].integral = from.integral + from.value * (keys_[k].at_s - from.at_s) +
                            integral_of(from, keys_[k], 1.0);
    }
}

// The integral of the difference from the value of `from`, from that key to a part u of the time.
// On a cubic between the velocities a and b over a time h the value is from + Δ(3u² − 2u³) + h(a(u
// − 2u² + u³) + b(u³ − u²)).
double Track::integral_of(const Key& from, const Key& to, double u) const {
    const double h = to.at_s - from.at_s;
    const double change = to.value - from.value;
    if (!is_cubic(from, to)) return change * h * to.easing->integral(u);
    const double rest = change * u * u * u * (1.0 - 0.5 * u);
    const double leaving = from.velocity * u * u * (0.5 + u * (0.25 * u - 2.0 / 3.0));
    const double arriving = to.velocity * u * u * u * (0.25 * u - 1.0 / 3.0);
    return h * (rest + h * (leaving + arriving));
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
    if (is_cubic(*from, *to)) {
        const double h = to->at_s - from->at_s;
        return from->value + (to->value - from->value) * (u * u * (3.0 - 2.0 * u)) +
               h * u * (1.0 - u) * (from->velocity * (1.0 - u) - to->velocity * u);
    }
    return from->value + (to->value - from->value) * to->easing->value(u);
}

double Track::integral(double film_s) const {
    const Key* from = key_before(film_s);
    const double since_s = film_s - from->at_s;
    const double steady = from->integral + from->value * since_s;
    if (from == &keys_.back() || since_s <= 0.0) return steady;
    const Key* to = from + 1;
    return steady + integral_of(*from, *to, since_s / (to->at_s - from->at_s));
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
