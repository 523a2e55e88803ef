// One option of a command, and where its value goes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace poinsot {

// Texts that add up when the option is given more than once.
struct Repeated {
    std::vector<std::string>* values;
};
// A text that is read when the line is; what it throws is what the user reads.
using ReadText = std::function<void(const std::string& text)>;

using OptionValue =
    std::variant<bool*, int*, std::string*, std::optional<int>*, std::optional<double>*,
                 std::optional<std::string>*, Repeated, ReadText>;

struct Option {
    std::string flags;  // "-o,--output"
    std::string help;
    OptionValue value;
    std::string wanted{};  // of a number: what it is, as "millimetres", for who gave none
    std::optional<std::string> type{};  // shown in the help; nothing: its kind
    bool required = false;
};

}  // namespace poinsot
