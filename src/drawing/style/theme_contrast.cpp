#include "drawing/style/theme_contrast.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "drawing/style/colour_vision.h"
#include "drawing/style/theme.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct Role {
    std::string_view name;
    Colour colour;
};

class ContrastChecks {
 public:
    explicit ContrastChecks(const Scene& scene) : scene_(scene), theme_(theme_of(scene)) {}

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

    void ask_contrast(const Role& line, const Role& ground, double least) {
        const double ratio = contrast(line.colour, ground.colour);
        if (ratio >= least) return;
        const auto key = key_of(line.name, ground.name);
        if (!key) return;
        notes_.push_back(fmt::format("{}{}: {} on {} has a contrast of {:.2f}, less than {}",
                                     scene_.where(*key), *key, line.name, ground.name, ratio,
                                     least));
    }

    void look_at_grounds() {
        const Role polhode{"polhode", theme_.polhode}, ellipsoid{"ellipsoid", theme_.ellipsoid};
        const Role plane{"plane", theme_.plane};
        ask_contrast(polhode, ellipsoid, 3.0);
        ask_contrast({"separatrix", theme_.separatrix}, ellipsoid, 3.0);
        ask_contrast(polhode, plane, 3.0);
        ask_contrast({"herpolhode", theme_.herpolhode}, plane, 3.0);
        std::vector<Role> grounds{{"halo", theme_.halo}};
        if (theme_.background.alpha > 0.0) {
            grounds = {{"ground", theme_.background.bottom}};
            if (!(theme_.background.top == theme_.background.bottom))
                grounds.push_back({"ground_top", theme_.background.top});
        }
        for (const Role& ground : grounds) {
            ask_contrast({"text", theme_.text}, ground, 4.5);
            for (const Role& line :
                 {Role{"momentum", theme_.momentum}, Role{"omega", theme_.omega},
                  Role{"e1", theme_.axes[0]}, Role{"e2", theme_.axes[1]},
                  Role{"e3", theme_.axes[2]}, Role{"theta", theme_.angles[0]},
                  Role{"phi", theme_.angles[1]}, Role{"psi", theme_.angles[2]},
                  Role{"energy", theme_.energy}, Role{"potential", theme_.potential}})
                ask_contrast(line, ground, 3.0);
        }
    }

    // Pairs of the same kind of object in one view that are distinguished by colour alone.
    void look_at_pairs() {
        const Role polhode{"polhode", theme_.polhode}, herpolhode{"herpolhode", theme_.herpolhode};
        const Role momentum{"momentum", theme_.momentum}, omega{"omega", theme_.omega};
        const std::array<Role, 3> axes{Role{"e1", theme_.axes[0]}, Role{"e2", theme_.axes[1]},
                                       Role{"e3", theme_.axes[2]}};
        const std::array<Role, 3> angles{Role{"theta", theme_.angles[0]},
                                         Role{"phi", theme_.angles[1]},
                                         Role{"psi", theme_.angles[2]}};
        const Role energy{"energy", theme_.energy}, potential{"potential", theme_.potential};
        const std::array<std::pair<Role, Role>, 13> pairs{{{polhode, herpolhode},
                                                           {polhode, momentum},
                                                           {polhode, omega},
                                                           {herpolhode, omega},
                                                           {herpolhode, momentum},
                                                           {momentum, omega},
                                                           {axes[0], axes[1]},
                                                           {axes[1], axes[2]},
                                                           {axes[2], axes[0]},
                                                           {angles[0], angles[1]},
                                                           {angles[1], angles[2]},
                                                           {angles[2], angles[0]},
                                                           {energy, potential}}};
        for (const auto& [a, b] : pairs) ask_difference(a, b);
    }

    // Adds one line per pair, for the kind of colour vision with the smallest difference.
    void ask_difference(const Role& a, const Role& b) {
        const auto key = key_of(a.name, b.name);
        if (!key) return;
        const Vision& worst = *std::min_element(
            visions().begin(), visions().end(), [&](const Vision& one, const Vision& other) {
                return line_difference(a.colour, b.colour, one) <
                       line_difference(a.colour, b.colour, other);
            });
        const double apart = line_difference(a.colour, b.colour, worst);
        if (apart >= 1.0) return;
        notes_.push_back(
            fmt::format("{}{}: {} and {} hardly differ{}: {:.2f} of the just-noticeable difference",
                        scene_.where(*key), *key, a.name, b.name, worst.eye, apart));
    }

    const Scene& scene_;
    Theme theme_;
    std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> contrast_notes(const Scene& scene) {
    if (scene.style.looks.empty()) return {};
    return ContrastChecks(scene).notes();
}

}  // namespace poinsot
