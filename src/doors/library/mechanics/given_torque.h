// A torque by the names that scenes give its kind and its numbers.
#pragma once

#include <poinsot/torque.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot::library {

// `kind`: "none", "gravity", "constant_body", "constant_space", "dissipation" or "drag"; `numbers`:
// one or three each, by name ("mgl_N_m"), SI units. Numbers that are not given keep their default.
// Throws InputError for an unknown kind, for numbers of another kind, and for a wrong count.
Torque given_torque(std::string_view kind,
                    const std::map<std::string, std::vector<double>>& numbers);

}  // namespace poinsot::library
