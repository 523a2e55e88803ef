#include "drawing/theme_contrast.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "drawing/theme.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// Linear light of an sRGB colour, IEC 61966-2-1.
Eigen::Vector3d linear(const Colour& colour) {
    const auto one = [](double x) {
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return {one(colour.r), one(colour.g), one(colour.b)};
}

const Eigen::Matrix3d& xyz_from_linear() {
    static const Eigen::Matrix3d matrix{{0.4124564, 0.3575761, 0.1804375},
                                        {0.2126729, 0.7151522, 0.0721750},
                                        {0.0193339, 0.1191920, 0.9503041}};
    return matrix;
}

// WCAG 2.1's contrast ratio, 1 to 21.
double contrast(const Colour& a, const Colour& b) {
    const auto luminance = [](const Colour& colour) {
        return xyz_from_linear().row(1).dot(linear(colour));
    };
    const auto [dim, bright] = std::minmax({luminance(a), luminance(b)});
    return (bright + 0.05) / (dim + 0.05);
}

// CIELAB of linear light beside the white of sRGB, CIE 15:2004.
Eigen::Vector3d lab(const Eigen::Vector3d& light) {
    const Eigen::Vector3d white = xyz_from_linear().rowwise().sum();
    const Eigen::Vector3d xyz =
        (xyz_from_linear() * light.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white);
    const auto f = [](double t) {
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    return {116.0 * f(xyz.y()) - 16.0, 500.0 * (f(xyz.x()) - f(xyz.y())),
            200.0 * (f(xyz.y()) - f(xyz.z()))};
}

// What linear light becomes to an eye that lacks a pigment: Machado, Oliveira & Fernandes, "A
// physiologically-based model for simulation of color vision deficiency" (2009), severity 1.
struct Vision {
    std::string_view name;
    Eigen::Matrix3d seen_from_linear;
};
const std::array<Vision, 4>& visions() {
    static const std::array<Vision, 4> all{{
        {"", Eigen::Matrix3d::Identity()},
        {" to an eye without red (protanopia)", Eigen::Matrix3d{{0.152286, 1.052583, -0.204868},
                                                                {0.114503, 0.786281, 0.099216},
                                                                {-0.003882, -0.048116, 1.051998}}},
        {" to an eye without green (deuteranopia)",
         Eigen::Matrix3d{{0.367322, 0.860646, -0.227968},
                         {0.280085, 0.672501, 0.047413},
                         {-0.011820, 0.042940, 0.968881}}},
        {" to an eye without blue (tritanopia)", Eigen::Matrix3d{{1.255528, -0.076749, -0.178779},
                                                                 {-0.078411, 0.930809, 0.147602},
                                                                 {0.004733, 0.691367, 0.303900}}},
    }};
    return all;
}

// How far two lines' colours are apart, in units of what half of all people notice between lines 4
// of 1080 rows wide that are seen from the middle of a lecture room: Stone, Szafir & Setlur, "An
// engineering model for color difference as a function of size" (2014).
double difference(const Colour& a, const Colour& b, const Vision& vision) {
    constexpr double half = 0.5;
    constexpr double width_deg = 4.0 / 1080.0 * 20.0;
    const Eigen::Vector3d noticed = half * (Eigen::Vector3d(10.16, 10.68, 10.70) +
                                            Eigen::Vector3d(1.50, 3.08, 5.74) / width_deg);
    const Eigen::Vector3d apart =
        lab(vision.seen_from_linear * linear(a)) - lab(vision.seen_from_linear * linear(b));
    return apart.cwiseQuotient(noticed).norm();
}

struct Role {
    std::string_view name;
    Colour colour;
};

class Looking {
 public:
    explicit Looking(const Scene& scene) : scene_(scene), theme_(theme_of(scene)) {}

    std::vector<std::string> notes() && {
        look_at_grounds();
        look_at_pairs();
        return std::move(notes_);
    }

 private:
    // The key that changed one of two colours, the later of them named first; nothing where neither
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

    // Of what one view shows as things of one kind, and colour alone tells apart.
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

    // One line for a pair, of the eye that tells it least.
    void ask_difference(const Role& a, const Role& b) {
        const auto key = key_of(a.name, b.name);
        if (!key) return;
        const Vision& worst = *std::min_element(
            visions().begin(), visions().end(), [&](const Vision& one, const Vision& other) {
                return difference(a.colour, b.colour, one) < difference(a.colour, b.colour, other);
            });
        const double apart = difference(a.colour, b.colour, worst);
        if (apart >= 1.0) return;
        notes_.push_back(fmt::format("{}{}: {} and {} hardly differ{}: {:.2f} of what is noticed",
                                     scene_.where(*key), *key, a.name, b.name, worst.name, apart));
    }

    const Scene& scene_;
    Theme theme_;
    std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> contrast_notes(const Scene& scene) {
    if (scene.style.looks.empty()) return {};
    return Looking(scene).notes();
}

}  // namespace poinsot
