// Manual pages, generated from the tables of commands, options and keys.
#include <fmt/format.h>

#include <string>

#include "cli/command.h"
#include "cli/documents.h"
#include "cli/option_texts.h"
#include "scene/scene_keys.h"

namespace poinsot {

namespace {

// Escapes a text for roff, so that no character acts as a command or a hyphen.
std::string roff(std::string_view text) {
    std::string set;
    for (const char c : text) {
        if (c == '\\')
            set += "\\e";
        else if (c == '-')
            set += "\\-";
        else if (c == '\'')
            set += "\\(aq";
        else if (c == '.' && set.empty())
            set += "\\&.";
        else
            set += c;
    }
    return set;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper(std::string_view text) {
    std::string letters(text);
    for (char& c : letters)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return letters;
}

// Without a date, so that the pages are reproducible.
std::string opening(std::string_view name, int section, std::string_view summary) {
    return fmt::format(".TH {} {} \"\" \"poinsot {}\" \"{}\"\n.SH NAME\n{} \\- {}\n",
                       roff(upper(name)), section, POINSOT_VERSION,
                       section == 1 ? "User Commands" : "File Formats", roff(name), roff(summary));
}

std::string paragraph(std::string_view heading, std::string_view text) {
    return fmt::format(".TP\n{}\n{}\n", heading, text);
}

std::string examples_of(const Command& command) {
    std::string text;
    for (const Example& example : command.examples)
        text += paragraph(bold(example.line), roff(example.does));
    return text;
}

const char* const exit_status =
    ".SH EXIT STATUS\n.TP\n0\nsuccess\n.TP\n1\nthe check failed: pictures differ, a limit is "
    "exceeded\n.TP\n2\nwrong command line or scene\n.TP\n3\nthe program could not do it: no "
    "OpenGL, disk full, encoder failed\n";

std::string page_name(const Command& command) { return fmt::format("poinsot-{}", command.name); }

std::string see_also(std::string_view pages) { return fmt::format(".SH SEE ALSO\n{}\n", pages); }

}  // namespace

std::string program_manual() {
    std::string text = opening(
        "poinsot", 1, "exact pictures and films of a rotating rigid body (Poinsot's construction)");
    text += fmt::format(
        ".SH SYNOPSIS\n{} {} [{}] [{}]\n.SH DESCRIPTION\nReads a scene file, computes the motion "
        "of the body and writes pictures and films of it. Needs neither a display nor a GPU. Data "
        "go to stdout, messages to stderr.\n.SH COMMANDS\n",
        bold("poinsot"), italic("COMMAND"), italic("OPTIONS"), italic("ARGUMENTS"));
    std::string pages;
    for (const Command& command : commands()) {
        text += paragraph(bold(command.name), roff(command.summary));
        pages += fmt::format("{}(1), ", bold(page_name(command)));
    }
    text += ".SH OPTIONS\n";
    text += paragraph(bold("-h, --help"), "print the commands");
    text += paragraph(bold("--version"), "print the version");
    text += exit_status;
    text += ".SH EXAMPLES\n";
    for (const Command& command : commands().first(2)) text += examples_of(command);
    return text + see_also(pages + bold("poinsot-scene") + "(5)");
}

std::string command_manual(std::string_view page) {
    for (const Command& command : commands()) {
        if (page != page_name(command) + ".1") continue;
        std::string text = opening(page_name(command), 1, command.summary);
        text += fmt::format(".SH SYNOPSIS\n{}\n.SH OPTIONS\n", roff(usage(command)));
        for (const OptionText& option : option_texts(command)) {
            std::string heading;
            for (const std::string& flag : option.flags)
                heading += (heading.empty() ? "" : ", ") + bold(flag);
            if (!option.takes.empty()) heading += " " + italic(option.takes);
            text += paragraph(heading, roff(option.help));
        }
        text += std::string(exit_status) + ".SH EXAMPLES\n" + examples_of(command);
        return text + see_also(fmt::format("{}(1), {}(5)", bold("poinsot"), bold("poinsot-scene")));
    }
    return "";
}

std::string scene_manual() {
    std::string text = opening("poinsot-scene", 5, "scene files of poinsot");
    text += fmt::format(
        ".SH DESCRIPTION\nA scene is a TOML file with strict keys: poinsot refuses an unknown key, "
        "a wrong type or a number out of range, and names the file, line and column. The command "
        "line can set any key, as in {} or {}.\n.SH EXAMPLE\n.nf\n{}\n\n{}\n{}\n\n{}\n{}\n.fi\n",
        bold("--set film.speed=0.5"), bold("--set 'panels[0].kind=plan'"),
        roff("title = \"Tennis racket\""), roff("[body]"), roff("moments_kg_m2 = [3.0, 2.0, 1.0]"),
        roff("[start]"), roff("omega_rad_s = [0.01, 2.0, 0.01]"));
    std::string_view table = "-";
    for (const SceneKey& key : scene_keys()) {
        if (key.table() != table) {
            table = key.table();
            text += table.empty() ? ".SH TOP OF THE FILE\n"
                                  : fmt::format(".SH \"{}\"\n", roff(written_table(table)));
        }
        text += paragraph(bold(fmt::format("{} = {}", key.leaf(), key.example)),
                          roff(key.explanation()));
    }
    return text + see_also(bold("poinsot") + "(1)");
}

}  // namespace poinsot
