#include "cli/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "cli/command.h"
#include "cli/option_texts.h"
#include "cli/option_values.h"
#include "error/error.h"
#include "system/files/memory_limits.h"
#include "system/files/standard_streams.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace poinsot {

// The commands of the table, one file each.
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
extern const Command fit_command;
extern const Command rerender_command;
extern const Command recover_command;
extern const Command join_command;
extern const Command submit_command;
extern const Command status_command;

namespace {

// Returns "--output" for "-o,--output", the option's name in messages.
std::string long_name(const std::string& flags) {
    const std::size_t begin = flags.find("--");
    return flags.substr(begin, flags.find(',', begin) - begin);
}

// Converts "REF NEW" to one name, "REF_NEW", for CLI11.
std::string argument_name(std::string_view arguments) {
    std::string name(arguments);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

// Binds options by kind: CLI11 only passes on the text, which is parsed here.
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
        });
    }
    CLI::Option* operator()(const Repeated& repeated) const {
        return (*this)(
            ReadEach{[to = repeated.values](const std::string& value) { to->push_back(value); }});
    }
    CLI::Option* operator()(const ReadEach& each) const {
        const auto read_all = [read = each.read](const std::vector<std::string>& values) {
            std::for_each(values.begin(), values.end(), read);
        };
        return app
            .add_option_function<std::vector<std::string>>(option.flags, read_all, option.help)
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
        return read_by([value, name = long_name(option.flags),
                        wanted = option.wanted](const std::string& given) {
            *value = parse_whole(name, given, wanted);
        });
    }
};

// CLI11 parses "--set a=b" correctly, but its messages differ from ours; this throws ours.
// `command` is the command whose help is named, empty for the program's.
[[noreturn]] void refuse(const std::string& what, std::string_view command = {}) {
    throw InputError(fmt::format("poinsot{0}{1}: {2}; see poinsot{0}{1} --help",
                                 command.empty() ? "" : " ", command, what));
}

// The flags "-o" and "--output" of "-o,--output", each with its option; null for help.
std::map<std::string, const Option*> flags_of(const std::vector<Option>& options) {
    std::map<std::string, const Option*> flags{{"--help", nullptr}, {"-h", nullptr}};
    for (const Option& option : options) {
        std::size_t begin = 0;
        while (begin < option.flags.size()) {
            const std::size_t end = std::min(option.flags.find(',', begin), option.flags.size());
            flags[option.flags.substr(begin, end - begin)] = &option;
            begin = end + 1;
        }
    }
    return flags;
}

// Whether an argument can only be an option: "-1.5" is a number, "-" a file.
bool looks_like_option(std::string_view argument) {
    return argument.size() > 1 && argument[0] == '-' &&
           std::string_view("0123456789.").find(argument[1]) == std::string_view::npos;
}

// Names the arguments from one index on: "REF and NEW are".
std::string named_arguments(std::string_view arguments, std::size_t first) {
    std::istringstream words{std::string(arguments)};
    std::vector<std::string> names{std::istream_iterator<std::string>(words), {}};
    names.erase(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(first));
    return fmt::format("{}{}", fmt::join(names, " and "), names.size() > 1 ? " are" : " is");
}

// Checks a command line before CLI11 does, for our own messages: an unknown option (CLI11 counts
// it, with its value, among the arguments), an option without its value or given twice, too few or
// too many arguments.
class LineCheck {
 public:
    LineCheck(const Command& command, const std::vector<Option>& options)
        : command_(command), flags_(flags_of(options)) {}

    // False if the line requests help, so that no error is thrown.
    bool check(std::span<const char* const> line) {
        std::vector<std::string_view> arguments;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string_view word = line[i];
            if (word == "--") {
                arguments.insert(arguments.end(), line.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 line.end());
                break;
            }
            if (!looks_like_option(word)) {
                arguments.push_back(word);
                continue;
            }
            const bool is_long = word.starts_with("--");
            const std::size_t equals = word.find('=');
            // A one-letter option may be joined with its value: "-oturn.png".
            const std::string flag(word.substr(0, is_long ? equals : 2));
            const Option* option = known(flag, word.substr(0, equals), is_long);
            if (option == nullptr) return false;
            if (std::holds_alternative<bool*>(option->value)) continue;
            refuse_twice(*option);
            const bool holds_value = is_long ? equals != std::string_view::npos : word.size() > 2;
            if (holds_value) continue;
            if (i + 1 == line.size() || flags_.contains(line[i + 1])) refuse_without_value(*option);
            ++i;
        }
        check_number(arguments);
        return true;
    }

 private:
    const Option* known(const std::string& flag, std::string_view given, bool is_long) const {
        const auto found = flags_.find(flag);
        if (found != flags_.end()) return found->second;
        std::vector<std::string_view> names;
        names.reserve(flags_.size());
        for (const auto& [name, option] : flags_) names.push_back(name);
        refuse(fmt::format("unknown option \"{}\"{}", printable(given),
                           is_long ? did_you_mean(flag, names) : ""),
               command_.name);
    }

    void refuse_twice(const Option& option) {
        const bool may_repeat = std::holds_alternative<Repeated>(option.value) ||
                                std::holds_alternative<ReadEach>(option.value);
        if (may_repeat || given_.insert(&option).second) return;
        refuse(fmt::format("{} was given twice; give it once", long_name(option.flags)),
               command_.name);
    }

    [[noreturn]] void refuse_without_value(const Option& option) const {
        std::string example;
        for (const OptionText& text : option_texts(command_))
            if (text.flags.back() == long_name(option.flags)) example = text.takes;
        refuse(fmt::format("{0} has no value; write {0} {1}", long_name(option.flags), example),
               command_.name);
    }

    void check_number(const std::vector<std::string_view>& arguments) const {
        const auto least = static_cast<std::size_t>(command_.least_arguments);
        const auto most = static_cast<std::size_t>(command_.most_arguments);
        if (!command_.needs.empty() && (arguments.size() < least || arguments.size() > most))
            refuse(fmt::format("needs {}; {} given", command_.needs,
                               arguments.empty()       ? "none is"
                               : arguments.size() == 1 ? "one is"
                                                       : fmt::format("{} are", arguments.size())),
                   command_.name);
        if (arguments.size() < least)
            refuse(named_arguments(command_.arguments, arguments.size()) + " missing",
                   command_.name);
        if (arguments.size() > most)
            refuse(fmt::format("\"{}\" is one argument too many; {} takes {}",
                               printable(arguments[most]), command_.name,
                               most == 0 ? "none" : fmt::format("{} alone", command_.arguments)),
                   command_.name);
    }

    const Command& command_;
    std::map<std::string, const Option*> flags_;
    std::set<const Option*> given_;
};

// A failed write to stdout must not exit with success.
void flush_stdout() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        if (errno == EPIPE) throw ReaderGone("stdout is closed");
        throw EnvironmentError(fmt::format("stdout: {}; the output is incomplete",
                                           std::strerror(errno != 0 ? errno : EIO)));
    }
}

}  // namespace

std::span<const Command> commands() {
    static const std::array table{
        render_command,  still_command,    check_command,   sample_command,
        compare_command, approve_command,  explain_command, rerender_command,
        recover_command, join_command,     submit_command,  status_command,
        fit_command,     tradeoff_command, list_command,    doctor_command};
    return table;
}

std::function<int()> read_command_line(int argc, const char* const* argv) {
    CLI::App app(
        "Draws exact pictures and films of a rotating rigid body (Poinsot's construction).",
        "poinsot");
    app.require_subcommand(1);
    app.set_version_flag("--version", "poinsot " POINSOT_VERSION);

    // Suggests the nearest command for a mistyped one, which CLI11 does not.
    const std::vector<std::string_view> names = names_of(commands());
    if (argc < 2)
        refuse(fmt::format("no command was given; choose from: {}", fmt::join(names, ", ")));
    if (argv[1][0] != '-') {
        if (std::find(names.begin(), names.end(), argv[1]) == names.end())
            refuse(unknown("command", argv[1], names));
    } else if (constexpr std::array<std::string_view, 3> known{"--help", "-h", "--version"};
               std::find(known.begin(), known.end(), argv[1]) == known.end()) {
        refuse(fmt::format("unknown option \"{}\"; name a command first", printable(argv[1])));
    }

    // CLI11 fills in the options of a command, which its `run` owns.
    std::function<int()> chosen;
    std::string_view named;
    for (const Command& command : commands()) {
        const CommandLine line = command.line();
        CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
        auto* arguments = sub->add_option(argument_name(command.arguments), *line.arguments);
        arguments->expected(command.least_arguments, command.most_arguments);
        if (command.least_arguments > 0) arguments->required();
        for (const Option& option : line.options) std::visit(Binder{*sub, option}, option.value);
        sub->formatter_fn([&command](const CLI::App*, const std::string&, CLI::AppFormatMode) {
            return help_of(command);
        });
        sub->callback([&chosen, run = line.run] { chosen = run; });
        if (argc > 1 && command.name == argv[1]) {
            named = command.name;
            if (!LineCheck(command, line.options).check({argv + 2, argv + argc})) {
                fmt::print("{}", sub->help());
                return [] { return 0; };
            }
        }
    }

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        // Prints the requested help or version.
        app.exit(success);
        return [] { return 0; };
    } catch (const CLI::ParseError& error) {
        refuse(error.what(), named);
    }
    return chosen;
}

void prepare_process() {
    occupy_closed_streams();
    check_stack();
    set_stack_of_threads();
}

int run_program(int argc, const char* const* argv) {
    const std::function<int()> command = read_command_line(argc, argv);
    const int code = command();
    flush_stdout();
    return code;
}

}  // namespace poinsot
