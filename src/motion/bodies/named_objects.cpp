#include "bodies/named_objects.h"

#include <array>
#include <utility>

#include "bodies/object_makers.h"
#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

constexpr std::array<NamedObject, 16> object_rows{{
    {"t-handle", "T-shaped handle, as spun on the space station; flips about its stem",
     "proportions as seen in NASA's film of the tumbling T-handle (none are published); O'Reilly, "
     "rotations.berkeley.edu/a-tumbling-t-handle-in-space; aluminium, 2700 kg/m^3",
     object_makers::t_handle},
    {"racket", "strung tennis racket; flips about the axis across its face",
     "ITF Rules of Tennis, appendix II (size); mass, balance, swingweight and twistweight of a "
     "modern racket: Brody, Phys. Teach. 23 (1985) 213; Taraborrelli et al., Sports Eng. 22 "
     "(2019), doi:10.1007/s12283-019-0303-8",
     object_makers::racket},
    {"book", "hardback of 400 pages",
     "royal octavo, 234 x 156 mm (BS 1413); 80 g/m^2 paper of 0.11 mm; 2.5 mm greyboard of 650 "
     "kg/m^3",
     object_makers::book},
    {"phone", "mobile phone: glass in front, a bump for the cameras at the back",
     "Apple, iPhone 15 technical specifications: 147.6 x 71.6 x 7.80 mm, 171 g; the sizes of the "
     "bump and of the glass's rim are poinsot's own choice",
     object_makers::phone},
    {"football", "American football, a hollow spindle",
     "NFL Rulebook, rule 2, section 1; shape between a spheroid and a parabola of revolution: Horn "
     "& Fearn, arXiv:0706.0366",
     object_makers::football},
    {"plate", "Feynman's dinner plate, with a medallion on its rim",
     "Feynman, Surely You're Joking (1985); Chao, Phys. Today 42 (2) (1989) 15; a restaurant plate "
     "of 10 1/2 inches, porcelain of 2400 kg/m^3",
     object_makers::plate},
    {"disc", "compact disc: moments very nearly 1 : 1 : 2",
     "ECMA-130 (1996): 120 mm, hole of 15 mm, 1.2 mm thick, 14 to 33 g; polycarbonate, "
     "1200 kg/m^3",
     object_makers::disc},
    {"coin", "two-euro coin",
     "Council Regulation (EU) 729/2014, annex I: 25.75 mm, 2.20 mm, 8.50 g; core of 18.75 mm",
     object_makers::coin},
    {"box", "brick: three unequal edges",
     "BS EN 771-1, work size 215 x 102.5 x 65 mm; fired clay, 1900 kg/m^3", object_makers::box},
    {"cylinder", "international prototype of the kilogram: height equal to diameter, so prolate",
     "BIPM: platinum-iridium, 1 kg, height and diameter 39.17 mm", object_makers::cylinder},
    {"cone", "wooden cone, three times as high as its base's radius",
     "the size is poinsot's own choice; sugar maple at 12 % moisture, 705 kg/m^3: Wood Handbook, "
     "USDA FPL-GTR-282 (2021), table 5-3",
     object_makers::cone},
    {"ellipsoid", "dwarf planet Haumea, a triaxial ellipsoid",
     "Ortiz et al., Nature 550 (2017) 219: half-axes 1161, 852, 513 km, 1885 kg/m^3",
     object_makers::ellipsoid},
    {"sphere", "pool ball", "WPA equipment specifications, section 16: 57.15 mm, 156 to 170 g",
     object_makers::sphere},
    {"torus", "lifebuoy", "IMO LSA Code, 2.1.1: outer diameter 800 mm, inner 400 mm, 2.5 kg",
     object_makers::torus},
    {"earth", "the Earth as mantle and core, for its Euler wobble of 305 days",
     "mass, WGS 84 figure and C/Ma^2 = 0.3307: IERS Conventions (2010), table 1.1, and Williams, "
     "Astron. J. 108 (1994) 711; core radius 3480 km: Dziewonski & Anderson, Phys. Earth Planet. "
     "Inter. 25 (1981) 297; its flattening 1/393: Denis et al., Geophys. J. Int. 132 (1998) 603",
     object_makers::earth},
    {"toutatis", "asteroid 4179 Toutatis as two lobes in contact; tumbles about its long axis",
     "length and widths, ratios of moments: Hudson & Ostro, Science 270 (1995) 84; lobes: Huang et "
     "al., Sci. Rep. 3 (2013) 3411; 2500 kg/m^3: Scheeres et al., Icarus 132 (1998) 53",
     object_makers::toutatis},
}};

}  // namespace

std::span<const NamedObject> named_objects() { return object_rows; }

const NamedObject& object_named(std::string_view name) {
    if (const NamedObject* row = find_row(object_rows, name)) return *row;
    throw InputError(unknown("object", name, names_of(object_rows)));
}

BodyProperties properties_of(std::span<const ObjectPart> parts) {
    std::vector<DensePart> dense;
    dense.reserve(parts.size());
    for (const ObjectPart& part : parts) {
        if (part.use == PartUse::look_only) continue;
        dense.push_back({mass_properties(part.mesh), part.density_kg_m3});
    }
    return body_of_parts(dense);
}

namespace object_makers {

std::vector<ObjectPart> of_mass(std::vector<ObjectPart> parts, double mass_kg) {
    double volume_m3 = 0.0;
    for (const ObjectPart& part : parts)
        if (part.use != PartUse::look_only) volume_m3 += mass_properties(part.mesh).volume_m3;
    for (ObjectPart& part : parts) part.density_kg_m3 = mass_kg / volume_m3;
    return parts;
}

std::vector<ObjectPart> centred(std::vector<ObjectPart> parts) {
    const Eigen::Vector3d centre = properties_of(parts).centre_of_mass_m;
    for (ObjectPart& part : parts) {
        for (Eigen::Vector3d& v : part.mesh.vertices) v -= centre;
    }
    return parts;
}

}  // namespace object_makers

}  // namespace poinsot
