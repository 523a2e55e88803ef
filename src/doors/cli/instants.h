// Parses instants of a motion from a command line or a file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// Parses a comma-separated list of: an instant "T"; a range "first:last:step", whose instants are
// first + k·step up to last; "first:last/n", n evenly spaced instants from first to last, both
// included: first + k·(last − first)/(n − 1). Each instant is the double nearest to the exact value
// of these decimals. "-" reads standard input like a file of instants_in. Seconds. Throws
// InputError.
std::vector<double> parse_times(std::string_view text);

// Parses instants separated by white space or commas; '#' begins a comment. `name` is used in
// messages. Throws InputError with the place of a text that is not an instant.
std::vector<double> instants_of(std::string_view text, const std::string& name);

// Reads a file of such instants; "-" is standard input. Throws InputError.
std::vector<double> instants_in(const std::string& file);

}  // namespace poinsot
