#include "drawing/stage/type/type_sizes.h"

#include <algorithm>

namespace poinsot {

double paper_type_px(const Scene& scene, double px, const LeastSizes& least) {
    constexpr double script_share = 0.7;  // of a subscript, as the fonts for formulas say
    const double name_px = label_size * scene.type_scale;
    return std::max({px, least.type_px / name_px, least.script_px / (script_share * name_px)});
}

}  // namespace poinsot
