#include "drawing/style/theme_contrast.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "drawing/style/colour_vision.h"
#include "drawing/style/theme_roles.h"
#include "numerics/srgb.h"
#include "text/printable.h"

namespace poinsot {

namespace {

class ContrastChecks {
 public:
    ContrastChecks(const Scene& scene, const Theme& theme) : scene_(scene), theme_(theme) {}

    std::vector<std::string> notes() && {
        look_at_grounds();
        look_at_pairs();
        return std::move(notes_);
    }

 private:
    // The key that changed one of two colours, that of `a` if both were changed; empty if neither
    // was.
    std::optional<std::string> key_of(std::string_view a, std::string_view b) const {
        for (const std::string_view name : {a, b}) {
            const auto found = scene_.style.looks.find(name);
            if (found != scene_.style.looks.end() && found->second.srgb)
                return fmt::format("style.{}", name);
        }
        return std::nullopt;
    }

    Colour colour(std::string_view role) { return *look_of(theme_, role).colour; }

    void ask_contrast(std::string_view line, std::string_view ground, double least) {
        const double ratio = contrast(colour(line), colour(ground));
        if (ratio >= least) return;
        const auto key = key_of(line, ground);
        if (!key) return;
        notes_.push_back(fmt::format("{}{}: {} on {} has a contrast of {:.2f}, less than {}",
                                     scene_.where(*key), *key, line, ground, ratio, least));
    }

    void look_at_grounds() {
        ask_contrast("polhode", "ellipsoid", 3.0);
        ask_contrast("separatrix", "ellipsoid", 3.0);
        ask_contrast("polhode", "plane", 3.0);
        ask_contrast("herpolhode", "plane", 3.0);
        std::vector<std::string_view> grounds{"halo"};
        if (theme_.background.alpha > 0.0) {
            grounds = {"ground"};
            if (!(theme_.background.top == theme_.background.bottom))
                grounds.emplace_back("ground_top");
        }
        for (const std::string_view ground : grounds) {
            ask_contrast("text", ground, 4.5);
            for (const std::string_view line :
                 {"momentum", "omega", "rho", "gradient", "torque", "e1", "e2", "e3", "mark",
                  "theta", "phi", "psi", "energy", "potential"})
                ask_contrast(line, ground, 3.0);
        }
    }

    // Pairs of the same kind of object in one view that are distinguished by colour alone.
    void look_at_pairs() {
        constexpr std::pair<std::string_view, std::string_view> pairs[] = {
            {"polhode", "herpolhode"},
            {"polhode", "momentum"},
            {"polhode", "omega"},
            {"herpolhode", "omega"},
            {"herpolhode", "momentum"},
            {"momentum", "omega"},
            {"rho", "momentum"},
            {"rho", "omega"},
            {"rho", "polhode"},
            {"rho", "gradient"},
            {"gradient", "momentum"},
            {"torque", "momentum"},
            {"torque", "omega"},
            {"torque", "e1"},
            {"torque", "e2"},
            {"torque", "e3"},
            {"mark", "herpolhode"},
            {"phi", "e3"},
            {"e1", "e2"},
            {"e2", "e3"},
            {"e3", "e1"},
            {"theta", "phi"},
            {"phi", "psi"},
            {"psi", "theta"},
            {"energy", "potential"}};
        for (const auto& [a, b] : pairs) ask_difference(a, b);
        for (const OneColour& group : one_colour_)
            notes_.push_back(
                fmt::format("{}{}: {} have one colour; only their names and shapes tell them apart",
                            scene_.where(group.key), group.key, fmt::join(group.roles, ", ")));
    }

    // Adds one line per pair, for the kind of colour vision with the smallest difference.
    void ask_difference(std::string_view a, std::string_view b) {
        const auto key = key_of(a, b);
        if (!key) return;
        const auto difference = [&](const Vision& vision) {
            return line_difference(colour(a), colour(b), vision);
        };
        const Vision& worst = *std::min_element(visions().begin(), visions().end(),
                                                [&](const Vision& one, const Vision& other) {
                                                    return difference(one) < difference(other);
                                                });
        const double apart = difference(worst);
        if (apart >= 1.0) return;
        if (colour(a) == colour(b) && n_of_colour(colour(a)) > 2)
            return add_to_one_colour(*key, a, b);
        notes_.push_back(
            fmt::format("{}{}: {} and {} hardly differ{}: {:.2f} of the just-noticeable difference",
                        scene_.where(*key), *key, a, b, worst.eye, apart));
    }

    // How many of the scene's own roles have this colour.
    int n_of_colour(const Colour& colour) {
        int n = 0;
        for (const auto& [role, look] : scene_.style.looks)
            n += look.srgb && *look_of(theme_, role).colour == colour ? 1 : 0;
        return n;
    }

    // A theme of one colour gets one note instead of one for each pair.
    void add_to_one_colour(const std::string& key, std::string_view a, std::string_view b) {
        auto group = std::find_if(one_colour_.begin(), one_colour_.end(),
                                  [&](const OneColour& each) { return each.colour == colour(a); });
        if (group == one_colour_.end()) group = one_colour_.insert(group, {colour(a), key, {}});
        for (const std::string_view role : {a, b})
            if (std::find(group->roles.begin(), group->roles.end(), role) == group->roles.end())
                group->roles.push_back(role);
    }

    struct OneColour {
        Colour colour;
        std::string key;
        std::vector<std::string_view> roles;
    };

    const Scene& scene_;
    Theme theme_;
    std::vector<std::string> notes_;
    std::vector<OneColour> one_colour_;
};

}  // namespace

std::vector<Colour> grounds_of(const Theme& theme) {
    if (theme.background.alpha > 0.0)
        return {theme.halo, theme.background.bottom, theme.background.top};
    return {theme.halo};
}

Colour letter_colour(const Theme& theme, const Colour& colour) {
    if (colour == theme.text) return colour;
    // Slightly more than 4.5, for rounding to 8 bits.
    constexpr double wanted = 4.55, flare = 0.05;
    double darkest = 1.0, lightest = 0.0;
    for (const Colour& ground : grounds_of(theme)) {
        darkest = std::min(darkest, relative_luminance(ground));
        lightest = std::max(lightest, relative_luminance(ground));
    }
    const double now = relative_luminance(colour);
    const auto each = [&colour](const auto& changed) {
        const auto part = [&changed](double encoded) {
            return srgb_from_linear(changed(linear_from_srgb(encoded)));
        };
        return Colour{part(colour.r), part(colour.g), part(colour.b)};
    };
    if (relative_luminance(theme.text) < darkest) {
        const double most = std::max((darkest + flare) / wanted - flare, 0.0);
        if (now <= most) return colour;
        return each([&](double light) { return light * (most / now); });
    }
    const double least = std::min((lightest + flare) * wanted - flare, 1.0);
    if (now >= least) return colour;
    return each([&](double light) { return light + (1.0 - light) * (least - now) / (1.0 - now); });
}

LineStyle path_of_e3(const Theme& theme) {
    const auto half_way = [](double a, double b) {
        return srgb_from_linear(0.5 * (linear_from_srgb(a) + linear_from_srgb(b)));
    };
    LineStyle path = theme.axes[2];
    path.r = half_way(path.r, theme.text.r);
    path.g = half_way(path.g, theme.text.g);
    path.b = half_way(path.b, theme.text.b);
    return path;
}

std::vector<std::string> contrast_notes(const Scene& scene, const Theme& theme) {
    if (scene.style.looks.empty()) return {};
    return ContrastChecks(scene, theme).notes();
}

}  // namespace poinsot
