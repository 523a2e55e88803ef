// Documents that the program generates for other programs: the schema of scene files, manual pages
// and shell completions, each from the tables of commands, options and keys.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct Document {
    std::string name;  // "poinsot-render.1", the installed name
    std::string summary;
    std::string (*text)(std::string_view name);
};

// Printed by `poinsot list NAME`; `poinsot list documents` lists them.
std::vector<Document> documents();

// The JSON Schema of a scene file (draft 4, which TOML editors support).
std::string scene_schema();

// Manual pages in roff (man(7)): of the program, "poinsot-render.1" of a command, of scene files.
std::string program_manual();
std::string command_manual(std::string_view page);
std::string scene_manual();

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace poinsot
