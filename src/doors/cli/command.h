// The table of commands: one file each, one row each.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option.h"

namespace poinsot {

// Value of most_arguments without a limit, as CLI11 defines it.
inline constexpr int any_number = 1 << 29;

// The command line of one command. `run` owns the variables that receive arguments and options.
struct CommandLine {
    std::vector<std::string>* arguments = nullptr;
    std::vector<Option> options;
    std::function<int()> run;  // call after parsing: the exit code; throws Error
};

// An example command line, and what it does.
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
    CommandLine (*line)();
    std::array<Example, 2> examples{};  // that its help ends with
    std::string_view needs{};           // its arguments in words, where they are more than one
};

std::span<const Command> commands();

}  // namespace poinsot
