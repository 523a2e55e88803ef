// The table of commands: one file each, one row each.
#pragma once

#include <any>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option.h"

namespace poinsot {

// As most_arguments: CLI11's own word for it.
inline constexpr int any_number = 1 << 29;

// A command whose line can be read.
struct CommandLine {
    std::vector<std::string>* arguments = nullptr;
    std::vector<Option> options;
    std::function<int()> run;  // once the line has been read: the exit code; throws Error
};

// One line that a user may type, and what it does.
struct Example {
    std::string_view line;
    std::string_view does;
};

struct Command {
    std::string_view name;
    std::string_view arguments;  // "SCENE", as shown in the usage
    int least_arguments;
    int most_arguments;
    std::string_view summary;
    // `room` keeps the command's own choices until it has run.
    CommandLine (*line)(std::any& room);
    std::array<Example, 2> examples{};  // that its help ends with
    std::string_view needs{};           // its arguments in words, where they are more than one
};

std::span<const Command> commands();

}  // namespace poinsot
