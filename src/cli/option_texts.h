// The tables of commands and options as help, manual pages and completions show them.
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace poinsot {

// One option, in words.
struct OptionText {
    std::vector<std::string> flags;  // "-o", "--output"
    std::string takes;               // "FILE"; empty of a switch
    std::string help;
    std::string completes;  // as in Option
    bool required = false;

    // "-o, --output FILE"
    std::string heading() const;
};

// The options of a command, with --help as the last.
std::vector<OptionText> option_texts(const Command& command);

// "poinsot render [OPTIONS] SCENE..."
std::string usage(const Command& command);

// What `poinsot COMMAND --help` prints.
std::string help_of(const Command& command);

// What a shell may complete a command's arguments with, as in Option.
std::string_view completes_arguments(const Command& command);

// The words that stand for `completes`: the names of a list, or the words themselves. Empty for
// files and folders, and for scenes, which are asked for when they are wanted.
std::vector<std::string> words_of(std::string_view completes);

}  // namespace poinsot
