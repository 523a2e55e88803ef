// poinsot check SCENE --against FILE: how far a motion of another program, or a measured one, is
// from the scene's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options.h"

namespace poinsot {

struct AgainstChoices {
    std::string file;       // the table
    std::string tolerance;  // "0.5 px", "0.01 rad", "1 deg"; empty: the scene's accuracy_px
    std::string chart;      // PNG to write; empty: none
    bool json = false;
};

// Prints what differs, and returns 0 within the tolerance and 1 past it. Throws InputError,
// EnvironmentError.
int check_against(const SceneRequest& request, const AgainstChoices& choices, const Task& task);

}  // namespace poinsot
