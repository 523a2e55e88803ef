#include "drawing/stage/type/label_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "error/error.h"

namespace poinsot {

namespace {

using Box = Eigen::AlignedBox2d;

Box box_of(const Label& label) {
    return {label.top_left_px,
            label.top_left_px + Eigen::Vector2d(label.mask->width_px(), label.mask->height_px())};
}

// Area of the overlap as a fraction of the smaller box.
double shared(const Box& a, const Box& b) {
    const Box both = a.intersection(b);
    if (both.isEmpty()) return 0.0;
    return both.volume() / std::max(std::min(a.volume(), b.volume()), 1e-9);
}

// Whether a label is text that is seen: nearly invisible text is ignored.
bool is_type(const Label& label) {
    constexpr double least_opacity = 0.2;
    return label.mask != nullptr && !label.mask->letters.empty() && label.opacity >= least_opacity;
}

bool is_on_page(const Box& box, const Drawing& drawing) {
    // A small part of a letter may extend beyond the page.
    const double slack = 0.25 * box.sizes().y();
    const Box page(Eigen::Vector2d(-slack, -slack),
                   Eigen::Vector2d(drawing.width_px + slack, drawing.height_px + slack));
    return page.contains(box);
}

}  // namespace

void leave_out_type(Drawing& drawing) {
    std::vector<Label*> labels;
    for (View& view : drawing.views)
        for (Label& label : view.labels)
            if (is_type(label)) labels.push_back(&label);
    std::stable_sort(labels.begin(), labels.end(),
                     [](const Label* a, const Label* b) { return a->rank < b->rank; });
    constexpr double least_shared = 0.1;  // boxes that overlap less seldom have overlapping letters
    constexpr double names_shared = 0.5;
    std::vector<Box> kept;
    for (Label* label : labels) {
        const Box box = box_of(*label);
        const bool is_name = label->rank == rank_of_names;
        const bool covers = std::any_of(kept.begin(), kept.end(), [&](const Box& other) {
            return shared(box, other) > (is_name ? names_shared : least_shared);
        });
        if (covers && is_name)
            throw InputError(
                "the picture is too small for its labels: they would overlap; make it larger, or "
                "show fewer elements");
        if (is_name || (!covers && is_on_page(box, drawing)))
            kept.push_back(box);
        else {
            const SetText& source = label->mask->source;
            drawing.left_out.push_back(source.is_formula ? "$" + source.text + "$" : source.text);
            label->opacity = 0.0;
        }
    }
    for (View& view : drawing.views)
        std::erase_if(view.labels, [](const Label& label) { return !(label.opacity > 0.0); });
}

}  // namespace poinsot
