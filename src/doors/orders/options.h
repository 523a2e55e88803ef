// The options that several doors share: the command line, the library, Python. Each is a row of one
// table, from which its flag, help, completions, keyword, checks and messages follow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "orders/poinsot/options.h"
#include "production/session/files/open_session.h"
#include "production/stills/picture.h"
#include "production/vectors/vector_still.h"
#include "scene/override.h"

namespace poinsot {

// What a user of a door chose; without a choice, the defaults.
struct GivenOptions {
    std::vector<Override> overrides{};  // also of options that stand for a scene's key
    bool allow_outside = false;
    std::optional<double> time_s{};  // of the motion
    bool clearest = false;           // time "auto"
    library::PaperOptions paper{};
    VectorChoices vectors{};
    int depth = 8;                                                  // bits of a colour component
    std::optional<std::pair<std::int64_t, std::int64_t>> frames{};  // inclusive, from 0
    library::ContextOptions context{};
};

// What can be asked for, as bits: each option belongs to some.
struct Verb {
    enum : unsigned {
        still = 1,
        figure = 2,  // a still of vectors
        film = 4,
        slides = 8,
        page = 16,
        check = 32,
        submit = 64,
        tradeoff = 128,
        rerender = 256,
        sheet = 512,          // many stills in one PNG
        figure_sheet = 1024,  // many figures on one page
    };
    static constexpr unsigned sheets = sheet | figure_sheet;
    static constexpr unsigned every_drawing = still | figure | film | slides | page | sheets;
};

// Where the value of an option goes. Options that stand for a scene's key have none.
struct InstantSlot {
    std::optional<double>* time_s;
    bool* clearest;
};
struct FramesSlot {
    std::optional<std::pair<std::int64_t, std::int64_t>>* frames;
};
using OptionSlot =
    std::variant<bool*, int*, std::string*, std::optional<double>*, InstantSlot, FramesSlot>;

struct OptionRow {
    std::string_view name;  // the keyword: "width_mm"
    unsigned verbs;
    std::string_view takes{};  // name of the value in the help: "WxH"; empty: by its kind
    std::string help;
    std::string_view wanted{};               // of a number: its meaning, for messages
    std::string_view completes{};            // as in Option
    std::string_view key{};                  // the scene's key that it gives a value
    OptionSlot (*slot)(GivenOptions&) = {};  // without a key
    std::string_view own_flag{};             // "--time"; empty: "--width-mm" from the name

    std::string flag() const;
};

// The table, in the order of the help.
std::span<const OptionRow> option_rows();

// Whether a value other than the default was chosen.
bool is_given(const OptionRow& row, const GivenOptions& given);

SceneRequest scene_request_of(std::string file, const GivenOptions& given,
                              const std::vector<Override>& more_overrides = {});
OutsideFiles outside_files(bool allow_outside);
PrintChoices print_choices(const library::PaperOptions& paper);
// Throws InputError for a backend that does not exist.
ContextChoice context_choice_of(const GivenOptions& given);

}  // namespace poinsot
