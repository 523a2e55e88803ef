// One option of a command, and the variable that receives its value.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poinsot {

// Texts of an option that may be given more than once.
struct Repeated {
    std::vector<std::string>* values;
};
// A text that is parsed with the command line; the user sees the exceptions of `read`. The function
// is wrapped in a struct: libstdc++ 12 treats a variant with a bare std::function as never
// valueless, and destroys an unconstructed one if memory runs out during a copy.
struct ReadText {
    std::function<void(const std::string& text)> read;
};
// The same for an option that may be given more than once.
struct ReadEach {
    std::function<void(const std::string& text)> read;
};

using OptionValue =
    std::variant<bool*, int*, std::string*, std::optional<int>*, std::optional<double>*,
                 std::optional<std::string>*, Repeated, ReadText, ReadEach>;

struct Option {
    std::string flags;    // "-o,--output"
    std::string takes{};  // name of the value in the help: "WxH"; empty: by its kind
    std::string help;
    OptionValue value;
    std::string wanted{};  // of a number: its meaning, such as "millimetres", for messages
    // What shells complete the value with: a list of `poinsot list`, "file", "folder", or the words
    // themselves, "auto|osmesa|egl".
    std::string completes{};
};

}  // namespace poinsot
