#include "drawing/stage/type/named_thing.h"

#include <algorithm>
#include <array>
#include <variant>

#include "numerics/smooth_step.h"

namespace poinsot {

namespace {

constexpr std::array<NamedThing, named_things.size() + 3> things{{
    {"body-cone",
     "cones",
     "body",
     "body_cone",
     225.0,
     true,
     {"body cone", "Gangpolkegel", "cône du corps", "cono del cuerpo", "cono solidale", "物体錐"}},
    {"space-cone",
     "cones",
     "space",
     "space_cone",
     30.0,
     true,
     {"space cone", "Rastpolkegel", "cône fixe", "cono fijo", "cono fisso", "空間錐"}},
    {"herpolhode",
     "herpolhode",
     "",
     "herpolhode",
     40.0,
     true,
     {"herpolhode", "Herpolhodie", "herpolhodie", "herpolodia", "erpolodia", "ハーポルホード"}},
    {"polhode",
     "polhode",
     "",
     "polhode",
     200.0,
     false,
     {"polhode", "Polhodie", "polhodie", "polodia", "polodia", "ポルホード"}},
    {"separatrix",
     "separatrix",
     "",
     "separatrix",
     320.0,
     false,
     {"separatrix", "Separatrix", "séparatrice", "separatriz", "separatrice", "分離線"}},
    {"inertia-ellipsoid",
     "ellipsoid",
     "",
     "text",
     225.0,
     true,
     {"inertia ellipsoid", "Trägheitsellipsoid", "ellipsoïde d'inertie", "elipsoide de inercia",
      "ellissoide d'inerzia", "慣性楕円体"}},
    {"unit-sphere",
     "unit-sphere",
     "",
     "text",
     135.0,
     true,
     {"unit sphere", "Einheitskugel", "sphère unité", "esfera unidad", "sfera unitaria", "単位球"}},
    {"invariable-plane",
     "plane",
     "",
     "text",
     140.0,
     true,
     {"invariable plane", "invariable Ebene", "plan invariable", "plano invariable",
      "piano invariabile", "不変平面"}},
    {"measured",
     "measured",
     "",
     "measured",
     320.0,
     true,
     {"measured", "gemessen", "mesuré", "medido", "misurato", "測定値"}},
    {"momentum-sphere",
     "momentum-sphere",
     "",
     "text",
     135.0,
     true,
     {"momentum sphere", "Drehimpulskugel", "sphère du moment", "esfera del momento",
      "sfera del momento", "角運動量球"}},
    {"energy-ellipsoid",
     "momentum-sphere",
     "ellipsoid",
     "text",
     225.0,
     true,
     {"energy ellipsoid", "Energieellipsoid", "ellipsoïde d'énergie", "elipsoide de energía",
      "ellissoide dell'energia", "エネルギー楕円体"}},
    {"rotation-axis",
     "spin-axis",
     "",
     "omega",
     290.0,
     true,
     {"axis of rotation", "Drehachse", "axe de rotation", "eje de rotación", "asse di rotazione",
      "回転軸"}},
}};

}  // namespace

std::span<const NamedThing> things_with_names() { return things; }

double NameSpan::presence(double film_s) const {
    return smooth_step(std::min(film_s - begin_s, end_s - film_s) / name_fade_s);
}

std::string_view words_of_plane(const Scene& scene, std::string_view thing, const Phrase& words) {
    static constexpr Phrase tangent_plane{"tangent plane",  "Tangentialebene", "plan tangent",
                                          "plano tangente", "piano tangente",  "接平面"};
    const bool moves = thing == "invariable-plane" && is_slowed(scene.torque);
    return phrase_in(scene.language, moves ? tangent_plane : words);
}

std::vector<ThingWords> words_of_things(const Scene& scene) {
    std::vector<ThingWords> words;
    for (const NamedThing& thing : things) {
        constexpr std::array lines{"body-cone", "space-cone", "herpolhode", "polhode",
                                   "separatrix"};
        if (std::find(lines.begin(), lines.end(), thing.name) == lines.end()) continue;
        words.push_back({std::string(phrase_in(scene.language, thing.words)), thing.role});
        const auto own = scene.symbols.things.find(thing.name);
        if (own != scene.symbols.things.end() && own->second.find('$') == std::string::npos)
            words.push_back({own->second, thing.role});
    }
    return words;
}

}  // namespace poinsot
