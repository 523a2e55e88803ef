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
// A text that is read when the line is; what it throws is what the user reads. No std::function by
// itself: libstdc++ 12 takes a variant of one for never without a value, and destroys what was
// never made where memory runs out while one is copied.
struct ReadText {
    std::function<void(const std::string& text)> read;
};

using OptionValue =
    std::variant<bool*, int*, std::string*, std::optional<int>*, std::optional<double>*,
                 std::optional<std::string>*, Repeated, ReadText>;

struct Option {
    std::string flags;  // "-o,--output"
    std::string help;
    OptionValue value;
    std::string wanted{};  // of a number: what it is, as "millimetres", for who gave none
    // What it takes, as shown: "WxH". Nothing: what stands before ": " in the help, or its kind.
    std::optional<std::string> type{};
    bool required = false;
    // What a shell may complete it with: a list of `poinsot list`, "file", "folder", or the words
    // themselves, "auto|osmesa|egl".
    std::string completes{};
};

}  // namespace poinsot
