// A number that keyframes change: its value at any second of the film, and its integral, both in
// closed form.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/easing.h"

namespace poinsot {

// Between two keys the value follows the later key's easing; before the first key and after the
// last it is constant. If the easing of a key continues through it, the value passes the key with a
// velocity that follows from the adjacent keys, on cubics that stay between the keys' values.
// Source: Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300.
class Track {
 public:
    // Starts at a value, from film second 0 on.
    explicit Track(double value = 0.0);

    // Adds a key. Precondition: at_s is not before the last key. A key at the same instant replaces
    // the last one.
    void add(double at_s, double value, const Easing& easing);

    double at(double film_s) const;

    // Integral from film second 0, signed. Sums over whole intervals are computed once, each in
    // closed form, so that the error does not grow with the number of video frames.
    double integral(double film_s) const;

    // Whether it ever differs from its first value.
    bool moves() const;
    double first_value() const { return keys_.front().value; }
    double last_value() const { return keys_.back().value; }
    double last_key_s() const { return keys_.back().at_s; }
    double least() const;
    double greatest() const;

 private:
    struct Key {
        double at_s = 0.0;
        double value = 0.0;
        const Easing* easing = nullptr;
        double integral = 0.0;  // from film second 0 to here
        double velocity = 0.0;  // of the value at this key
    };
    // Whether the value moves from one key to the next on a cubic with given end velocities.
    static bool is_cubic(const Key& from, const Key& to);
    void pass_through(std::size_t key);
    double integral_of(const Key& from, const Key& to, double u) const;
    // The last key at or before an instant.
    const Key* key_before(double film_s) const;

    std::vector<Key> keys_;
};

}  // namespace poinsot
