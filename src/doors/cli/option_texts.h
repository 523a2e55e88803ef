// The tables of commands and options as text for help, manual pages and completions.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "scene/value_type.h"

namespace poinsot {

// The texts of one option.
struct OptionText {
    std::vector<std::string> flags;  // "-o", "--output"
    std::string takes;               // "FILE"; empty for a switch
    std::string help;
    std::string completes;  // like Option::completes

    // "-o, --output FILE"
    std::string heading() const;
};

// Returns the options of a command, with --help as the last.
std::vector<OptionText> option_texts(const Command& command);

// "poinsot render [OPTIONS] SCENE..."
std::string usage(const Command& command);

// Returns the text of `poinsot COMMAND --help`.
std::string help_of(const Command& command);

// Returns what shells complete a command's arguments with, as in Option.
std::string_view completes_arguments(const Command& command);

// Returns the words that `completes` means: the names of a list, or the words themselves. Empty for
// files and folders, and for scenes, whose names the completions request when needed.
std::vector<std::string> words_of(std::string_view completes);

// Returns the words that a scene key accepts, singly or in a list; empty if these are not fixed.
std::vector<std::string> words_of(const ValueType& type);

}  // namespace poinsot
