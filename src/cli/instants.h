// Instants of a motion as a command line or a file names them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// Between commas: an instant "T", a range "first:last:step", whose instants are first + k·step as
// far as last, or "first:last/n", n instants evenly from first to last, both among them: first +
// k·(last − first)/(n − 1). Each instant is the double nearest to what these decimals give exactly.
// "-" reads standard input as instants_in does a file. Seconds. Throws InputError.
std::vector<double> parse_times(std::string_view text);

// A file of instants between white space or commas, '#' beginning a comment; "-" is standard input.
// Throws InputError with the place of what is no instant.
std::vector<double> instants_in(const std::string& file);

}  // namespace poinsot
