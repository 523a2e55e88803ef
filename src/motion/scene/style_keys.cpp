#include "scene/style_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "scene/scene_error.h"
#include "scene/scene_key_rows.h"
#include "text/nearest.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

using std::size_t;

constexpr StyleRole roles[] = {
    {"ground", StyleKind::surface, "the background; 0% makes it transparent"},
    {"ground_top", StyleKind::colour, "the upper edge of the background, for a gradient"},
    {"text", StyleKind::colour, "title, captions and headings"},
    {"halo", StyleKind::colour, "the halo that separates type from what is behind it"},
    {"omega", StyleKind::line, "ω"},
    {"momentum", StyleKind::line, "L"},
    {"rho", StyleKind::line, "ρ and its projection on L"},
    {"gradient", StyleKind::line, "∇F"},
    {"torque", StyleKind::line, "the torque N"},
    {"e1", StyleKind::line, "the first principal axis and components along it"},
    {"e2", StyleKind::line, "the second principal axis and components along it"},
    {"e3", StyleKind::line, "the third principal axis and components along it"},
    {"polhode", StyleKind::line, "the polhode"},
    {"herpolhode", StyleKind::line, "the herpolhode"},
    {"contact", StyleKind::colour, "the contact point"},
    {"mark", StyleKind::line, "points of [[marks]] and their paths"},
    {"ellipsoid", StyleKind::surface, "the inertia ellipsoid"},
    {"ellipsoid_lines", StyleKind::colour, "the lines on the ellipsoid"},
    {"plane", StyleKind::surface, "the invariable plane"},
    {"grid", StyleKind::colour, "the grid on the plane"},
    {"measured", StyleKind::line, "the points and the track of a measured motion"},
    {"annulus", StyleKind::line, "the circles that bound the herpolhode"},
    {"separatrix", StyleKind::line, "the separatrices"},
    {"body_cone", StyleKind::colour, "the body cone"},
    {"space_cone", StyleKind::colour, "the space cone"},
    {"sphere", StyleKind::colour, "the sphere of constant |L|"},
    {"solid", StyleKind::colour, "body surfaces that define no colour"},
    {"solid_lines", StyleKind::line, "the lines on bodies"},
    {"theta", StyleKind::line, "the angle θ"},
    {"phi", StyleKind::line, "the angle φ"},
    {"psi", StyleKind::line, "the angle ψ"},
    {"energy", StyleKind::line, "E and T"},
    {"potential", StyleKind::line, "V and the axes given in the scene"},
    {"ghost", StyleKind::line, "the motion of the second method"},
    {"rule", StyleKind::line, "the axes of charts"},
};

// The sixteen colour names of HTML 4, and orange.
struct NamedColour {
    std::string_view name;
    std::uint32_t rgb;
};
constexpr NamedColour named_colours[] = {
    {"black", 0x000000},  {"silver", 0xc0c0c0}, {"gray", 0x808080},   {"white", 0xffffff},
    {"maroon", 0x800000}, {"red", 0xff0000},    {"purple", 0x800080}, {"fuchsia", 0xff00ff},
    {"green", 0x008000},  {"lime", 0x00ff00},   {"olive", 0x808000},  {"yellow", 0xffff00},
    {"navy", 0x000080},   {"blue", 0x0000ff},   {"teal", 0x008080},   {"aqua", 0x00ffff},
    {"orange", 0xffa500},
};

std::array<double, 3> srgb_of(std::uint32_t rgb) {
    const auto part = [rgb](int shift) {
        return static_cast<double>((rgb >> shift) & 0xff) / 255.0;
    };
    return {part(16), part(8), part(0)};
}

// "#9a247d", "#a2d" or a name.
std::optional<std::array<double, 3>> colour_of(std::string_view word) {
    for (const NamedColour& colour : named_colours)
        if (colour.name == word) return srgb_of(colour.rgb);
    if (!word.starts_with('#') || (word.size() != 4 && word.size() != 7)) return std::nullopt;
    std::string digits(word.substr(1));
    if (digits.size() == 3)
        digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    std::uint32_t rgb = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stopped, failed] = std::from_chars(digits.data(), end, rgb, 16);
    if (failed != std::errc{} || stopped != end) return std::nullopt;
    return srgb_of(rgb);
}

std::optional<double> finite_number(std::string_view word) {
    const auto number = number_of<double>(word);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string_view expectation_of(StyleKind kind) {
    switch (kind) {
        case StyleKind::line:
            return R"(give a colour, a weight and a line style, or some of them, as in "#9a247d 1.5 dashed")";
        case StyleKind::surface:
            return R"(give a colour and an opacity, or one of them, as in "#e8b56a 66%")";
        default:
            return R"(give a colour, as in "#9a247d")";
    }
}

[[noreturn]] void refuse_word(const GivenValue& given, std::string_view word, StyleKind kind) {
    std::vector<std::string_view> known;
    for (const NamedColour& colour : named_colours) known.push_back(colour.name);
    if (kind == StyleKind::line)
        known.insert(known.end(), line_kinds().begin(), line_kinds().end());
    const std::string near = word.starts_with('#') ? "" : did_you_mean(word, known);
    throw SceneError(given.value().where,
                     fmt::format("{} has \"{}\"{}", given.name(), printable(word),
                                 near.empty() ? fmt::format("; {}", expectation_of(kind)) : near));
}

// Takes a word as a value that a look of this kind has and that was not given yet; false otherwise.
bool takes(LookSpec& look, std::string_view word, StyleKind kind) {
    if (const auto srgb = colour_of(word); srgb && !look.srgb) {
        look.srgb = srgb;
        return true;
    }
    if (kind == StyleKind::line) {
        constexpr double least = 0.1, most = 10.0;
        if (const auto weight = finite_number(word);
            weight && *weight >= least && *weight <= most && !look.weight) {
            look.weight = weight;
            return true;
        }
        for (const std::string_view line : line_kinds()) {
            if (line != word || !look.line.empty()) continue;
            look.line = word;
            return true;
        }
    }
    if (kind == StyleKind::surface && word.ends_with('%')) {
        const auto percent = finite_number(word.substr(0, word.size() - 1));
        if (percent && *percent >= 0.0 && *percent <= 100.0 && !look.opacity_percent) {
            look.opacity_percent = percent;
            return true;
        }
    }
    return false;
}

LookSpec look_of(const GivenValue& given, StyleKind kind) {
    const std::string text = given.text();
    LookSpec look;
    bool empty = true;
    for (size_t at = text.find_first_not_of(" \t\n"); at < text.size();
         at = text.find_first_not_of(" \t\n", at)) {
        const std::string word = text.substr(at, text.find_first_of(" \t\n", at) - at);
        if (!takes(look, word, kind)) refuse_word(given, word, kind);
        at += word.size();
        empty = false;
    }
    if (empty) given.refuse("empty", expectation_of(kind));
    return look;
}

std::string text_of(const LookSpec& look) {
    std::vector<std::string> words;
    if (look.srgb) words.push_back(colour_text(*look.srgb));
    if (look.weight) words.push_back(fmt::format("{}", *look.weight));
    if (look.opacity_percent) words.push_back(fmt::format("{}%", *look.opacity_percent));
    if (!look.line.empty()) words.push_back(look.line);
    return toml_text(std::string_view(fmt::format("{}", fmt::join(words, " "))));
}

// The key of a role. The deque holds the texts to which its string views refer.
SceneKey role_row(const StyleRole& role) {
    static std::deque<std::string> words;
    const bool is_line = role.kind == StyleKind::line, is_surface = role.kind == StyleKind::surface;
    const std::string_view path = words.emplace_back(fmt::format("style.{}", role.name));
    const std::string_view of = is_line      ? "colour, weight and line style"
                                : is_surface ? "colour and opacity"
                                             : "colour";
    const std::string_view example = is_line      ? R"("#9a247d 1.5 dashed")"
                                     : is_surface ? R"("#e8b56a 66%")"
                                                  : R"("#9a247d")";
    return key_rows::row(path, {.kind = ValueType::Kind::text}, example,
                         words.emplace_back(fmt::format("{} of {}", of, role.what)))
        .read_by([&role](const GivenValue& given, SceneDraft& draft) {
            draft.scene.style.looks.insert_or_assign(std::string(role.name),
                                                     look_of(given, role.kind));
        })
        .written_by([&role](const Scene& scene, size_t) {
            const auto found = scene.style.looks.find(role.name);
            return found == scene.style.looks.end() ? "" : text_of(found->second);
        });
}

// Factor on the type size of one kind of text.
SceneKey scale_row(std::string_view path, std::optional<double> StyleSpec::*scale,
                   std::string_view summary) {
    return key_rows::number(path, in(&Scene::style, scale), within(0.25, 8.0), "", "1.25", summary)
        .default_is("1");
}

template <typename Value>
constexpr auto mark(Value MarkSpec::*member) {
    return in(&Scene::marks, member);
}

// A colour, or the name of a role, whose colour follows the theme.
void read_mark_colour(const GivenValue& given, SceneDraft& draft) {
    MarkSpec& mark = draft.scene.marks.at(given.item());
    if (const StyleRole* role = find_row(roles, given.text()))
        mark.role = role->name;
    else
        mark.srgb = look_of(given, StyleKind::colour).srgb;
}
std::string mark_colour_text(const Scene& scene, size_t item) {
    const MarkSpec& mark = scene.marks.at(item);
    if (mark.srgb) return toml_text(std::string_view(colour_text(*mark.srgb)));
    return mark.role == MarkSpec{}.role ? "" : toml_text(std::string_view(mark.role));
}

}  // namespace

std::span<const StyleRole> style_roles() { return roles; }

std::span<const std::string_view> line_kinds() {
    static constexpr std::array<std::string_view, 3> kinds{"solid", "dashed", "dotted"};
    return kinds;
}

std::span<const std::string_view> mark_places() {
    static constexpr std::array<std::string_view, 3> places{"ellipsoid", "body", "space"};
    return places;
}

std::string colour_text(const std::array<double, 3>& srgb) {
    const auto part = [](double x) { return static_cast<int>(std::lround(255.0 * x)); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(srgb[0]), part(srgb[1]), part(srgb[2]));
}

std::span<const SceneKey> style_keys() {
    static const std::vector<SceneKey> rows = [] {
        std::vector<SceneKey> all;
        for (const StyleRole& role : roles) all.push_back(role_row(role));
        all.push_back(scale_row("style.title_scale", &StyleSpec::title_scale,
                                "factor on the size of the title"));
        all.push_back(scale_row("style.caption_scale", &StyleSpec::caption_scale,
                                "factor on the size of captions and the clock"));
        all.push_back(scale_row("style.heading_scale", &StyleSpec::heading_scale,
                                "factor on the size of panels' headings"));
        all.push_back(scale_row("style.label_scale", &StyleSpec::label_scale,
                                "factor on the size of the labels in figures"));
        all.push_back(scale_row("style.chart_scale", &StyleSpec::chart_scale,
                                "factor on the size of all type in charts"));
        return all;
    }();
    return rows;
}

std::span<const SceneKey> mark_keys() {
    using namespace key_rows;
    static const SceneKey rows[] = {
        numbers("marks[].at", mark(&MarkSpec::at), coordinates, "", "[1.0, 0.0, 0.0]",
                "position of the point: direction in body axes (ellipsoid), coordinates in body "
                "axes in m (body), or coordinates like those of [camera] target (space)")
            .without_default(),
        one_of("marks[].on", mark(&MarkSpec::on), mark_places(), R"("body")",
               "what the point is fixed to"),
        text("marks[].name", mark(&MarkSpec::name), R"("P_1")", "label of the point, as a formula")
            .default_is("none"),
        boolean("marks[].trail", mark(&MarkSpec::trail), "true",
                "whether the path of the point is drawn")
            .omitted_if_default(),
        row("marks[].colour", {.kind = ValueType::Kind::text}, R"("#cf4a12")",
            "colour of the point and its path, or a key of [style] such as \"ghost\", whose colour "
            "follows the theme")
            .default_is("\"mark\"")
            .read_by(read_mark_colour)
            .written_by(mark_colour_text),
    };
    return rows;
}

}  // namespace poinsot
