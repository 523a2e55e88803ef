#include "cli/documents.h"

#include <fmt/format.h>

#include "cli/command.h"

namespace poinsot {

std::vector<Document> documents() {
    std::vector<Document> table{{"schema", "JSON Schema (draft 4) of scene files, for editors",
                                 [](std::string_view) { return scene_schema(); }},
                                {"completion.bash", "completions for bash",
                                 [](std::string_view) { return bash_completion(); }},
                                {"completion.zsh", "completions for zsh",
                                 [](std::string_view) { return zsh_completion(); }},
                                {"completion.fish", "completions for fish",
                                 [](std::string_view) { return fish_completion(); }},
                                {"poinsot.1", "manual page of the program",
                                 [](std::string_view) { return program_manual(); }},
                                {"poinsot-scene.5", "manual page of scene files",
                                 [](std::string_view) { return scene_manual(); }}};
    for (const Command& command : commands())
        table.push_back({fmt::format("poinsot-{}.1", command.name),
                         fmt::format("manual page of poinsot {}", command.name), command_manual});
    return table;
}

}  // namespace poinsot
