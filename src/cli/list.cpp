// poinsot list WHAT: the tables that the program is made of.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <vector>

#include "cli/catalogue.h"
#include "cli/command.h"
#include "cli/documents.h"
#include "cli/options.h"
#include "error/error.h"
#include "text/json_text.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

namespace {

struct ListChoices {
    std::vector<std::string> what;
    bool json = false;
};

int run(const ListChoices& choices) {
    std::vector<std::string_view> names;
    for (const Catalogue& catalogue : catalogues()) names.push_back(catalogue.name);
    names.emplace_back("schema");
    if (choices.what.empty()) {
        for (const std::string_view name : names) fmt::print("{}\n", name);
        return 0;
    }

    const std::string& what = choices.what[0];
    for (const Document& document : documents()) {
        if (document.name != what) continue;
        fmt::print("{}", document.text(document.name));
        return 0;
    }
    for (const Catalogue& catalogue : catalogues()) {
        if (catalogue.name != what) continue;
        const std::vector<CatalogueEntry> entries = catalogue.entries();
        std::size_t width = 0;
        for (const CatalogueEntry& entry : entries) width = std::max(width, entry.name.size());
        if (choices.json) fmt::print("[\n");
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (choices.json) {
                fmt::print("  {{\"name\": {}, \"summary\": {}}}{}\n", json_string(entries[i].name),
                           json_string(entries[i].summary), i + 1 < entries.size() ? "," : "");
            } else {
                fmt::print("{:{}}  {}\n", printable(entries[i].name), width,
                           printable(entries[i].summary, most_of_a_message));
            }
        }
        if (choices.json) fmt::print("]\n");
        if (!catalogue.note.empty()) say(catalogue.note);
        return 0;
    }
    throw InputError(fmt::format("poinsot list: nothing called \"{}\"{}; choose from: {}",
                                 printable(what), did_you_mean(what, names),
                                 fmt::join(names, ", ")));
}

CommandLine line(std::any& room) {
    auto& c = room.emplace<ListChoices>();
    return {&c.what, {json_option(c.json)}, [&c] { return run(c); }};
}

}  // namespace

const Command list_command{
    "list",
    "WHAT",
    0,
    1,
    "list scenes, keys, methods, elements, panels, objects, …",
    line,
    {{{"poinsot list", "what can be listed"}, {"poinsot list keys", "every key of a scene file"}}}};

}  // namespace poinsot
