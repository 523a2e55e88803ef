// Text as a JSON string.
#pragma once

#include <string>
#include <string_view>

namespace poinsot {

// Quoted and escaped (RFC 8259 §7).
std::string json_string(std::string_view text);

// A finite double with enough digits to give it back, otherwise null.
std::string json_number(double value);

}  // namespace poinsot
