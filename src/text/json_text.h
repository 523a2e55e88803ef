// Numbers in JSON; its strings are of text/.
#pragma once

#include <string>

#include "text/printable.h"

namespace poinsot {

// A finite double with enough digits to give it back, otherwise null.
std::string json_number(double value);

}  // namespace poinsot
