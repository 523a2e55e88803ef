// What the clock over a picture says: the instant in a unit and with the digits that the film's
// span asks for.
#pragma once

#include <string>

#include "drawing/type/time_unit.h"

namespace poinsot {

class ClockText {
 public:
    // For a film of the instants from first_s to last_s.
    ClockText(double first_s, double last_s);

    // A caption: "$t$ = 3.25 s". Its digits are as many as the film needs to move, and so few that
    // it stays short: at most eight, or a power of ten.
    std::string at(double time_s) const;

 private:
    TimeUnit unit_;
    int n_decimals_ = 2;
    bool with_exponent_ = false;
};

}  // namespace poinsot
