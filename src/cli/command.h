// The table of commands: one row and one file each.
#pragma once

#include <span>
#include <string_view>

#include "cli/options.h"

namespace poinsot {

// As most_arguments: CLI11's own word for it.
inline constexpr int any_number = 1 << 29;

struct Command {
    std::string_view name;
    std::string_view arguments;  // "SCENE", as shown in the usage
    int least_arguments;
    int most_arguments;
    std::string_view summary;
    std::span<const std::string_view> options;  // names of the option table that it takes
    int (*run)(const Options& options);         // exit code; throws Error
};

std::span<const Command> commands();

extern const Command render_command;
extern const Command still_command;
extern const Command check_command;
extern const Command sample_command;
extern const Command tradeoff_command;
extern const Command list_command;
extern const Command doctor_command;
extern const Command compare_command;
extern const Command approve_command;
extern const Command explain_command;
extern const Command rerender_command;
extern const Command recover_command;

}  // namespace poinsot
