// What the program writes of itself for other programs: the schema of scene files, manual pages and
// completions of shells, each made from the tables of commands, options and keys.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

struct Document {
    std::string name;  // "poinsot-render.1", as installed
    std::string summary;
    std::string (*text)(std::string_view name);
};

// Asked for as `poinsot list NAME`; `poinsot list documents` names them all.
std::vector<Document> documents();

// JSON Schema (draft 4, which TOML editors read) of a scene file.
std::string scene_schema();

// Manual pages in roff (man(7)): of the program, "poinsot-render.1" of a command, of scene files.
std::string program_manual();
std::string command_manual(std::string_view page);
std::string scene_manual();

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace poinsot
