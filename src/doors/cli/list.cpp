// poinsot list WHAT: prints the tables of the program.
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "cli/catalogue.h"
#include "cli/command.h"
#include "cli/documents.h"
#include "cli/options.h"
#include "error/error.h"
#include "text/json_text.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct ListChoices {
    std::vector<std::string> what;
    bool json = false;
};

// Columns of the terminal on stdout; none if stdout is not a terminal: lines are then not folded.
std::optional<std::size_t> terminal_width() {
    winsize size{};
    if (isatty(STDOUT_FILENO) == 0) return std::nullopt;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

// Folds the text at spaces to lines of at most `width` characters, with all lines but the first
// indented.
std::string folded(std::string_view text, std::size_t width, std::size_t indent) {
    std::string lines;
    std::size_t column = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        const std::size_t length = static_cast<std::size_t>(
            std::count_if(word.begin(), word.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
        if (column > 0 && column + 1 + length > width) {
            lines += "\n" + std::string(indent, ' ');
            column = 0;
        }
        if (column > 0) lines += ' ';
        lines += word;
        column += length + (column > 0 ? 1 : 0);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// The table of a key, "[camera]" for "camera.view"; empty for keys at the top of the scene.
std::string_view group_of(std::string_view key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string_view::npos ? std::string_view{} : key.substr(0, dot);
}

void print_entries(const std::vector<CatalogueEntry>& entries, bool grouped) {
    constexpr std::size_t between = 2;
    constexpr std::size_t least_summary = 24;
    std::size_t width = 0;
    for (const CatalogueEntry& entry : entries) width = std::max(width, entry.name.size());
    const auto terminal = terminal_width();
    const std::size_t summary_width =
        terminal ? std::max(least_summary, *terminal - std::min(*terminal, width + between))
                 : any_length;
    std::optional<std::string_view> group;
    for (const CatalogueEntry& entry : entries) {
        if (grouped && group && *group != group_of(entry.name)) fmt::print("\n");
        group = group_of(entry.name);
        fmt::print(
            "{:{}}  {}\n", printable(entry.name), width,
            folded(printable(entry.summary, most_of_a_message), summary_width, width + between));
    }
}

void print_json(const std::vector<CatalogueEntry>& entries) {
    std::vector<std::string> rows;
    rows.reserve(entries.size());
    for (const CatalogueEntry& entry : entries)
        rows.push_back(JsonObject().add("name", entry.name).add("summary", entry.summary).line());
    fmt::print("{}\n", json_lines(rows));
}

// The entries whose name or summary contains the word, case-insensitive.
std::vector<CatalogueEntry> holding(std::vector<CatalogueEntry> entries, const std::string& word) {
    const auto lower = [](std::string text) {
        for (char& c : text)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return text;
    };
    std::erase_if(entries, [&](const CatalogueEntry& entry) {
        return lower(entry.name).find(lower(word)) == std::string::npos &&
               lower(entry.summary).find(lower(word)) == std::string::npos;
    });
    return entries;
}

int run(const ListChoices& choices) {
    std::vector<std::string_view> names;
    for (const Catalogue& catalogue : catalogues()) names.push_back(catalogue.name);
    names.emplace_back("schema");
    if (choices.what.empty()) {
        if (choices.json) {
            std::vector<std::string> quoted;
            quoted.reserve(names.size());
            for (const std::string_view name : names) quoted.push_back(json_string(name));
            fmt::print("{}\n", json_lines(quoted));
            return 0;
        }
        for (const std::string_view name : names) fmt::print("{}\n", name);
        return 0;
    }

    const std::string& what = choices.what[0];
    for (const Document& document : documents()) {
        if (document.name != what) continue;
        if (choices.json && document.name != "schema")
            throw InputError(
                fmt::format("poinsot list {}: is a text, not a list; leave --json out", what));
        fmt::print("{}", document.text(document.name));
        return 0;
    }
    for (const Catalogue& catalogue : catalogues()) {
        if (catalogue.name != what) continue;
        std::vector<CatalogueEntry> entries = catalogue.entries();
        if (choices.what.size() > 1) {
            entries = holding(std::move(entries), choices.what[1]);
            if (entries.empty())
                throw InputError(fmt::format(
                    "poinsot list {}: no entry contains \"{}\"; poinsot list {} shows all", what,
                    printable(choices.what[1]), what));
        }
        if (choices.json) {
            print_json(entries);
        } else {
            print_entries(entries, catalogue.name == "keys");
        }
        return 0;
    }
    throw InputError(fmt::format("poinsot list: there is no list \"{}\"{}", printable(what),
                                 choose_instead(what, names)));
}

CommandLine list_line() {
    const auto choices = std::make_shared<ListChoices>();
    ListChoices& c = *choices;
    return {
        &c.what, {json_option(c.json, "print a JSON array")}, [choices] { return run(*choices); }};
}

}  // namespace

extern const Command list_command{
    "list",
    "WHAT WORD",
    0,
    2,
    "list every name that a scene or an option accepts",
    list_line,
    {{{"poinsot list", "prints the names of the lists"},
      {"poinsot list keys camera", "lists the scene keys that contain the word"}}}};

}  // namespace poinsot
