// The unit that an author writes by hand beside a number in a caption: "{omega_3}~rad/s".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "text/units.h"

namespace poinsot {

struct WrittenUnit {
    std::string text;  // without markup: "kg m²/s"
    Unit unit;
    // Words after it make another unit of it ("degrees a day"), so that it cannot be compared.
    bool goes_on = false;
};

// The unit at the beginning of what follows a number in a caption; nothing if there is none. It may
// be set as a formula. Where more than one can be read ("J in" may be joules or joule inches), the
// longest one of the number's dimension, or else the longest.
std::optional<WrittenUnit> written_unit(std::string_view after_number, const Dimension& of_number);

}  // namespace poinsot
