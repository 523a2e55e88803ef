// A number that keyframes move: its value at any second of the film, and its integral, both in
// closed form.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/easing.h"

namespace poinsot {

// Between two keys the value goes as the later one's easing says; before the first and after the
// last it stays. Through a key whose easing goes on it passes with the velocity that the keys
// beside it suggest, on cubics that stay between the keys' values. Source: Fritsch & Butland, SIAM
// J. Sci. Stat. Comput. 5 (1984) 300.
class Track {
 public:
    // Starts at a value, from film second 0 on.
    explicit Track(double value = 0.0);

    // Precondition: at_s does not lie before the last key. A key at the last one's instant takes
    // its place.
    void add(double at_s, double value, const Easing& easing);

    double at(double film_s) const;

    // Integral from film second 0, signed. Sums over whole stretches are made once, each in closed
    // form, so that the error does not grow with the number of video frames.
    double integral(double film_s) const;

    // Whether it ever leaves its first value.
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
        double velocity = 0.0;  // with which the value passes through
    };
    // Whether the way from a key to the next is a cubic between velocities.
    static bool is_cubic(const Key& from, const Key& to);
    void pass_through(std::size_t key);
    double integral_of(const Key& from, const Key& to, double u) const;
    // The last key at or before an instant.
    const Key* key_before(double film_s) const;

    std::vector<Key> keys_;
};

}  // namespace poinsot
