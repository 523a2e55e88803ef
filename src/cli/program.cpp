#include "cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <any>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "cli/command.h"
#include "cli/option_texts.h"
#include "cli/option_values.h"
#include "error/error.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

// What the table names, one file each.
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
extern const Command join_command;
extern const Command submit_command;
extern const Command status_command;

namespace {

// "--output" of "-o,--output", by which a message names the option.
std::string long_name(const std::string& flags) {
    const std::size_t begin = flags.find("--");
    return flags.substr(begin, flags.find(',', begin) - begin);
}

// "REF NEW" as one name, as CLI11 wants it: "REF_NEW".
std::string argument_name(std::string_view arguments) {
    std::string name(arguments);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

// How a value of each kind is read: CLI11 takes the text, and we read it.
struct Binder {
    CLI::App& app;
    const Option& option;

    CLI::Option* operator()(bool* value) const {
        return app.add_flag(option.flags, *value, option.help);
    }
    CLI::Option* operator()(std::string* value) const { return text(value); }
    CLI::Option* operator()(std::optional<std::string>* value) const { return text(value); }
    CLI::Option* operator()(int* value) const { return whole(value); }
    CLI::Option* operator()(std::optional<int>* value) const { return whole(value); }
    CLI::Option* operator()(std::optional<double>* value) const {
        return read_by([value, name = long_name(option.flags),
                        wanted = option.wanted](const std::string& given) {
                   *value = parse_number(name, given, wanted);
               })
            ->type_name("NUMBER");
    }
    CLI::Option* operator()(const Repeated& repeated) const {
        const auto append = [to = repeated.values](const std::vector<std::string>& values) {
            to->insert(to->end(), values.begin(), values.end());
        };
        return app.add_option_function<std::vector<std::string>>(option.flags, append, option.help)
            ->allow_extra_args(false)
            ->take_all();
    }
    CLI::Option* operator()(const ReadText& text) const { return read_by(text.read); }

    CLI::Option* read_by(const std::function<void(const std::string&)>& read) const {
        return app.add_option_function<std::string>(option.flags, read, option.help);
    }
    template <typename Text>
    CLI::Option* text(Text* value) const {
        return read_by([value, name = long_name(option.flags)](const std::string& given) {
            *value = parse_text(name, given);
        });
    }
    template <typename Whole>
    CLI::Option* whole(Whole* value) const {
        return read_by([value, name = long_name(option.flags), wanted = option.wanted](
                           const std::string& given) { *value = parse_whole(name, given, wanted); })
            ->type_name("N");
    }
};

void bind(CLI::App& app, const Option& option) {
    CLI::Option* bound = std::visit(Binder{app, option}, option.value);
    if (option.type) bound->type_name(*option.type);
    if (option.required) bound->required();
}

// CLI11 splits "--set a=b" rightly but has its own words for what is wrong; these are ours.
// `command` is whose help is named, empty for the program's.
[[noreturn]] void refuse(const std::string& what, std::string_view command = {}) {
    throw InputError(fmt::format("poinsot{0}{1}: {2}; see poinsot{0}{1} --help",
                                 command.empty() ? "" : " ", command, what));
}

// "-o" and "--output" of "-o,--output", each with whether a value follows it.
std::map<std::string, bool> flags_of(const std::vector<Option>& options) {
    std::map<std::string, bool> flags{{"--help", false}, {"-h", false}};
    for (const Option& option : options) {
        std::size_t begin = 0;
        while (begin < option.flags.size()) {
            const std::size_t end = std::min(option.flags.find(',', begin), option.flags.size());
            flags[option.flags.substr(begin, end - begin)] =
                !std::holds_alternative<bool*>(option.value);
            begin = end + 1;
        }
    }
    return flags;
}

// Whether an argument can only be meant as an option: "-1.5" is a number, "-" a file.
bool looks_like_option(std::string_view argument) {
    return argument.size() > 1 && argument[0] == '-' &&
           std::string_view("0123456789.").find(argument[1]) == std::string_view::npos;
}

// An option that a command does not have is called so, whatever else is wrong with the line: CLI11
// counts it, with its value, among the arguments.
void refuse_unknown_option(std::span<const char* const> arguments, const Command& command,
                           const std::vector<Option>& options) {
    const std::map<std::string, bool> flags = flags_of(options);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--") return;
        if (!looks_like_option(argument)) continue;
        const bool is_long = argument.starts_with("--");
        const std::size_t equals = argument.find('=');
        // A letter may have its value behind it: "-oturn.png".
        const std::string name(argument.substr(0, is_long ? equals : 2));
        const auto known = flags.find(name);
        if (known == flags.end()) {
            std::vector<std::string_view> names;
            names.reserve(flags.size());
            for (const auto& [flag, has_value] : flags) names.push_back(flag);
            refuse(fmt::format("unknown option \"{}\"{}", printable(argument.substr(0, equals)),
                               is_long ? did_you_mean(name, names) : ""),
                   command.name);
        }
        const bool holds_value = is_long ? equals != std::string_view::npos : argument.size() > 2;
        if (known->second && !holds_value) ++i;
    }
}

// Too few or too many arguments of a command, in its own words. CLI11 begins with its name for
// them.
void refuse_argument_count(const Command& command, const CLI::App& app, std::string_view error) {
    const std::string name = argument_name(command.arguments);
    if (command.needs.empty() || !error.starts_with(name)) return;
    const std::size_t n_given = app.get_option(name)->count();
    refuse(fmt::format("needs {}; {} given", command.needs,
                       n_given == 0   ? "none is"
                       : n_given == 1 ? "one is"
                                      : fmt::format("{} are", n_given)),
           command.name);
}

// Data that could not be printed must not look like success.
void flush_stdout() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        if (errno == EPIPE) throw ReaderGone("stdout is closed");
        throw EnvironmentError(fmt::format("stdout: {}; nothing more was printed",
                                           std::strerror(errno != 0 ? errno : EIO)));
    }
}

}  // namespace

std::span<const Command> commands() {
    static const std::array table{
        render_command,  still_command,   check_command,    sample_command,  compare_command,
        approve_command, explain_command, rerender_command, recover_command, join_command,
        submit_command,  status_command,  tradeoff_command, list_command,    doctor_command};
    return table;
}

CommandToRun read_command_line(int argc, const char* const* argv) {
    CLI::App app("Poinsot's construction of a turning rigid body: exact motion, drawn off-screen.",
                 "poinsot");
    app.require_subcommand(1);
    app.set_version_flag("--version", "poinsot " POINSOT_VERSION);

    // A mistyped command gets the nearest name, which CLI11 does not give.
    if (argc > 1 && argv[1][0] != '-') {
        const std::vector<std::string_view> names = names_of(commands());
        if (std::find(names.begin(), names.end(), argv[1]) == names.end())
            refuse(unknown("command", argv[1], names));
    }

    // Every command's choices, which CLI11 fills in and the one that was named reads.
    CommandToRun chosen;
    chosen.rooms.resize(commands().size());
    std::string_view named;
    for (std::size_t i = 0; i < commands().size(); ++i) {
        const Command& command = commands()[i];
        const CommandLine line = command.line(chosen.rooms[i]);
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        auto* arguments = sub->add_option(argument_name(command.arguments), *line.arguments);
        arguments->expected(command.least_arguments, command.most_arguments);
        if (command.least_arguments > 0) arguments->required();
        for (const Option& option : line.options) bind(*sub, option);
        sub->formatter_fn([&command](const CLI::App*, const std::string&, CLI::AppFormatMode) {
            return help_of(command);
        });
        sub->callback([&chosen, run = line.run] { chosen.run = run; });
        if (argc > 1 && command.name == argv[1]) {
            named = command.name;
            refuse_unknown_option({argv + 2, argv + argc}, command, line.options);
        }
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        // What was asked for is the text that is printed now.
        app.exit(success);
        chosen.run = [] { return 0; };
    } catch (const CLI::ParseError& error) {
        const auto command = std::find_if(commands().begin(), commands().end(),
                                          [named](const Command& c) { return c.name == named; });
        if (command != commands().end())
            refuse_argument_count(*command, *app.get_subcommand(std::string(named)), error.what());
        refuse(error.what(), named);
    }
    return chosen;
}

int run_program(int argc, const char* const* argv) {
    const CommandToRun command = read_command_line(argc, argv);
    const int code = command.run();
    flush_stdout();
    return code;
}

}  // namespace poinsot
