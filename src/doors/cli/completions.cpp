// Shell completions, generated from the tables of commands and options.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/documents.h"
#include "cli/option_texts.h"
#include "scene/scene_keys.h"

namespace poinsot {

namespace {

using std::string;

// Quotes a text in single quotes, in which all three shells change nothing but quotes.
string shell_quoted(std::string_view text) {
    string safe;
    for (const char c : text) safe += c == '\'' ? string("'\\''") : string(1, c);
    return "'" + safe + "'";
}

// Lists the scenes when a shell completes one; precedes a command's own completions.
constexpr std::string_view list_scenes = "poinsot list scenes 2>/dev/null | sed 's/ .*//'";

// Each key of --set with its "=", and with each word that it accepts; in an array of tables, for
// the first item.
std::vector<string> settings() {
    std::vector<string> words;
    for (const SceneKey& key : scene_keys()) {
        string start = fmt::format("{}=", key.path);
        if (const std::size_t item = start.find("[]"); item != string::npos)
            start.insert(item + 1, "0");
        words.push_back(start);
        for (const string& word : words_of(key.type)) words.push_back(start + word);
    }
    return words;
}

// The bash case that completes a value or an argument; empty if nothing is known.
string bash_words(std::string_view completes) {
    if (completes == "file") return "_poinsot_files";
    if (completes == "folder") return "_poinsot_files -d";
    if (completes == "scenes") return "_poinsot_scenes";
    if (completes == "keys") return "_poinsot_keys";
    const std::vector<string> words = words_of(completes);
    if (words.empty()) return ":";
    return fmt::format("_poinsot_words {}", shell_quoted(fmt::format("{}", fmt::join(words, " "))));
}

constexpr std::string_view bash_functions =
    R"bash(# Completions of poinsot for bash, made by `poinsot list completion.bash`.
_poinsot_words() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }
_poinsot_files() {
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    COMPREPLY=($(compgen "${1:--f}" -- "$cur"))
}
_poinsot_scenes() {
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    COMPREPLY=($(compgen -W "$(poinsot list scenes 2>/dev/null | sed 's/ .*//')" -- "$cur")
        $(compgen -f -X '!*.toml' -- "$cur") $(compgen -d -- "$cur"))
}
# Bash splits words at "=": only the part after it is completed.
_poinsot_keys() {
    cur=${key:+$key=}$cur
    _poinsot_words "$_poinsot_settings"
    if [[ $key ]]; then COMPREPLY=("${COMPREPLY[@]#"$key="}"); else compopt -o nospace 2>/dev/null; fi
}
)bash";

string bash_case(const Command& command) {
    string flags, values;
    for (const OptionText& option : option_texts(command)) {
        flags += fmt::format("{}{}", flags.empty() ? "" : " ", fmt::join(option.flags, " "));
        if (!option.takes.empty())
            values += fmt::format("                {}) {}; return ;;\n",
                                  fmt::join(option.flags, " | "), bash_words(option.completes));
    }
    return fmt::format(
        "        {})\n            case $prev in\n{}            esac\n"
        "            [[ $cur == -* ]] && {{ _poinsot_words {}; return; }}\n            {} ;;\n",
        command.name, values, shell_quoted(flags), bash_words(completes_arguments(command)));
}

string command_names() {
    std::vector<std::string_view> names;
    for (const Command& command : commands()) names.push_back(command.name);
    return fmt::format("{}", fmt::join(names, " "));
}

// Escapes a text for a specification of zsh's _arguments, and for its messages.
string zsh_text(std::string_view text) {
    string safe;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

string zsh_action(std::string_view completes) {
    if (completes == "file") return "_files";
    if (completes == "folder") return "_files -/";
    if (completes == "scenes" || completes == "keys") return fmt::format("_poinsot_{}", completes);
    const std::vector<string> words = words_of(completes);
    if (words.empty()) return " ";
    return fmt::format("({})", fmt::join(words, " "));
}

string zsh_case(const Command& command) {
    string specifications;
    for (const OptionText& option : option_texts(command)) {
        for (const string& flag : option.flags) {
            string specification = fmt::format("{}{}[{}]", option.completes == "keys" ? "*" : "",
                                               flag, zsh_text(option.help));
            if (!option.takes.empty())
                specification +=
                    fmt::format(":{}:{}", zsh_text(option.takes), zsh_action(option.completes));
            specifications += fmt::format(" \\\n                {}", shell_quoted(specification));
        }
    }
    if (!command.arguments.empty())
        specifications +=
            fmt::format(" \\\n                {}",
                        shell_quoted(fmt::format("*:{}:{}", command.arguments,
                                                 zsh_action(completes_arguments(command)))));
    return fmt::format("        {})\n            _arguments -s{} ;;\n", command.name,
                       specifications);
}

string fish_values(std::string_view completes) {
    if (completes == "file") return " -r -F";
    if (completes == "folder") return " -x -a '(__fish_complete_directories)'";
    if (completes == "keys") return " -x -a '$poinsot_settings'";
    const std::vector<string> words = words_of(completes);
    if (words.empty()) return " -x";
    return fmt::format(" -x -a {}", shell_quoted(fmt::format("{}", fmt::join(words, " "))));
}

string fish_lines(const Command& command) {
    const string start =
        fmt::format("complete -c poinsot -n '__fish_seen_subcommand_from {}'", command.name);
    string text;
    for (const OptionText& option : option_texts(command)) {
        string names;
        for (const string& flag : option.flags)
            names += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
        text += fmt::format("{}{}{} -d {}\n", start, names,
                            option.takes.empty() ? "" : fish_values(option.completes),
                            shell_quoted(option.help));
    }
    const std::string_view completes = completes_arguments(command);
    if (completes == "scenes")
        text += fmt::format("{} -F -a '({})'\n", start,
                            "poinsot list scenes 2>/dev/null | string replace -r \" .*\" \"\"");
    else if (completes == "file" || completes == "folder")
        text += fmt::format("{} -F\n", start);
    else if (!completes.empty())
        text += fmt::format("{} -a {}\n", start,
                            shell_quoted(fmt::format("{}", fmt::join(words_of(completes), " "))));
    return text;
}

}  // namespace

string bash_completion() {
    string text(bash_functions);
    text += fmt::format("_poinsot_settings='{}'\n", fmt::join(settings(), " "));
    text += R"bash(_poinsot() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} key=
    COMPREPLY=()
    if [[ $cur == = ]]; then cur='' key=$prev prev=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $prev == = ]]; then key=${COMP_WORDS[COMP_CWORD-2]} prev=${COMP_WORDS[COMP_CWORD-3]}; fi
)bash";
    text += fmt::format(
        "    if [[ $COMP_CWORD == 1 ]]; then _poinsot_words {}; return; fi\n"
        "    case ${{COMP_WORDS[1]}} in\n",
        shell_quoted(command_names() + " --help --version"));
    for (const Command& command : commands()) text += bash_case(command);
    return text + "    esac\n}\ncomplete -F _poinsot poinsot\n";
}

string zsh_completion() {
    string text = fmt::format(
        "#compdef poinsot\n# Completions of poinsot for zsh, made by `poinsot list "
        "completion.zsh`.\n"
        "_poinsot_scenes() {{\n    local -a scenes=(${{(f)\"$({})\"}})\n"
        "    _alternative 'scenes:scene:compadd -a scenes' 'files:file:_files -g \"*.toml\"'\n}}\n"
        "_poinsot_keys() {{\n    local -a keys=('{}')\n    compadd -S '' -a keys\n}}\n"
        "_poinsot() {{\n    if (( CURRENT == 2 )); then\n        local -a commands=(\n",
        list_scenes, fmt::join(settings(), "' '"));
    for (const Command& command : commands())
        text += fmt::format(
            "            {}\n",
            shell_quoted(fmt::format("{}:{}", command.name, zsh_text(command.summary))));
    text +=
        "        )\n        _describe command commands\n        return\n    fi\n"
        "    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $command in\n";
    for (const Command& command : commands()) text += zsh_case(command);
    return text + "    esac\n}\n_poinsot \"$@\"\n";
}

string fish_completion() {
    string text =
        "# Completions of poinsot for fish, made by `poinsot list completion.fish`.\n"
        "complete -c poinsot -f\n";
    text += fmt::format("set -g poinsot_settings '{}'\n", fmt::join(settings(), "' '"));
    text += "complete -c poinsot -n __fish_use_subcommand -l version -d 'print the version'\n";
    for (const Command& command : commands())
        text += fmt::format("complete -c poinsot -n __fish_use_subcommand -a {} -d {}\n",
                            command.name, shell_quoted(command.summary));
    for (const Command& command : commands()) text += fish_lines(command);
    return text;
}

}  // namespace poinsot
