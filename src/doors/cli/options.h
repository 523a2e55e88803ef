// Options that several commands share, each with its name and help.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option.h"
#include "orders/options.h"

namespace poinsot {

// The options of these verbs (bits of Verb) in the order of the table.
std::vector<Option> options_of(unsigned verbs, GivenOptions& given);

Option set_option(GivenOptions& given);
Option allow_outside_option(bool& allow_outside);

// The scene of a command's argument: a file, or a scene that comes with the program.
SceneRequest scene_request(const std::string& argument, const GivenOptions& given,
                           const std::vector<Override>& more_overrides = {});

Option output_option(std::string& output, std::string_view help = "output file");
// The answer is one JSON document, also for several scenes.
Option json_option(bool& json, std::string_view help = "print one JSON document");
Option quiet_option(bool& quiet);

// All groups, in this order.
std::vector<Option> joined(std::initializer_list<std::vector<Option>> groups);

}  // namespace poinsot
