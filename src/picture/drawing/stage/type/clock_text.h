// The text of the clock over a picture: the time, in a unit and with digits that suit the film's
// span.
#pragma once

#include <string>

#include "drawing/stage/type/time_unit.h"

namespace poinsot {

class ClockText {
 public:
    // For a film of the instants from first_s to last_s.
    ClockText(double first_s, double last_s);

    // A caption: "$t$ = 3.25 s". It has as many digits as needed to change during the film, but at
    // most eight; else a power of ten.
    std::string at(double time_s) const;

    // The format of the same instants in a caption, in a unit of which a second has `per_s`: ".2f",
    // as fine as the clock.
    std::string format_in(double per_s) const;

 private:
    TimeUnit unit_;
    int n_decimals_ = 2;
    bool with_exponent_ = false;
};

}  // namespace poinsot
