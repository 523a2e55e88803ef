#include "text/languages.h"

#include <algorithm>
#include <array>

namespace poinsot {

namespace {

constexpr std::array<std::string_view, 6> codes{"en", "de", "fr", "es", "it", "ja"};

// A row: English first, then as in `codes`.
using Row = std::array<std::string_view, codes.size()>;
constexpr Row words[] = {
    {"Invariable plane", "Invariable Ebene", "Plan invariable", "Plano invariable",
     "Piano invariabile", "不変平面"},
    {"Body axes", "Körperfeste Achsen", "Axes liés au corps", "Ejes del cuerpo",
     "Assi solidali al corpo", "物体座標系"},
    {"Herpolhode", "Herpolhodie", "Herpolhodie", "Herpolhodia", "Erpoloide", "ハーポロード"},
    {"Momentum in body axes", "Drehimpuls in körperfesten Achsen",
     "Moment cinétique dans les axes du corps", "Momento angular en ejes del cuerpo",
     "Momento angolare in assi solidali", "物体座標系の角運動量"},
    {"Body in space", "Körper im Raum", "Corps dans l\u2019espace", "Cuerpo en el espacio",
     "Corpo nello spazio", "空間内の物体"},
    {"Heavy top", "Schwerer Kreisel", "Toupie pesante", "Peonza pesada", "Trottola pesante",
     "重いこま"},
    {"Effective potential", "Effektives Potential", "Potentiel effectif", "Potencial efectivo",
     "Potenziale efficace", "有効ポテンシャル"},
    {"energy", "Energie", "énergie", "energía", "energia", "エネルギー"},
    {"turns", "Umdrehungen", "tours", "vueltas", "giri", "回転数"},
    {"relative residual", "relativer Rest", "résidu relatif", "residuo relativo",
     "residuo relativo", "相対残差"},
    {"angle from L", "Winkel zu L", "angle avec L", "ángulo con L", "angolo con L", "Lとの角度"},
    {"begins outside", "beginnt außerhalb", "commence hors du cadre", "empieza fuera",
     "inizia fuori", "始めは枠外"},
    {"thin lines", "dünne Linien", "traits fins", "líneas finas", "linee sottili", "細線"},
    {"wobble", "Taumeln", "nutation", "cabeceo", "nutazione", "ふらつき"},
    {"spin", "Spin", "rotation propre", "giro propio", "rotazione propria", "自転"},
    {"gap", "Abstand", "écart", "separación", "scarto", "隙間"},
    {"slip", "Schlupf", "glissement", "deslizamiento", "slittamento", "滑り"},
};

const Row* row_of(std::string_view english) {
    const auto found = std::find_if(std::begin(words), std::end(words),
                                    [english](const Row& row) { return row[0] == english; });
    return found == std::end(words) ? nullptr : &*found;
}

}  // namespace

std::span<const std::string_view> languages() { return codes; }

std::string_view translated(std::string_view english, std::string_view language) {
    const Row* row = row_of(english);
    if (row == nullptr) return english;
    const auto at = std::find(codes.begin(), codes.end(), language) - codes.begin();
    return (*row)[static_cast<std::size_t>(at) % codes.size()];
}

bool has_translations(std::string_view english) {
    const Row* row = row_of(english);
    return row != nullptr && std::none_of(row->begin(), row->end(),
                                          [](std::string_view word) { return word.empty(); });
}

}  // namespace poinsot
