#include "drawing/stage/type/label_fit.h"

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "drawing/stage/type/labels.h"

namespace poinsot {

namespace {

// Whether a label is text that is seen: nearly invisible text is ignored.
bool is_type(const Label& label) {
    constexpr double least_opacity = 0.2;
    return label.mask != nullptr && !label.mask->letters.empty() && label.opacity >= least_opacity;
}

bool is_on_page(const LabelBox& box, const Drawing& drawing) {
    // A small part of a letter may extend beyond the page.
    const double slack = 0.5 * box.half_px.y();
    const Eigen::Vector2d low = box.centre_px - box.half_px, high = box.centre_px + box.half_px;
    return low.minCoeff() >= -slack && high.x() <= drawing.width_px + slack &&
           high.y() <= drawing.height_px + slack;
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
    std::vector<LabelBox> kept;
    for (Label* label : labels) {
        const LabelBox box = label_box(*label);
        const bool covers = std::any_of(kept.begin(), kept.end(), [&](const LabelBox& other) {
            return box.shared_with(other) > least_shared;
        });
        // Labels of vectors are placed apart already.
        if (label->rank == rank_of_names || (!covers && is_on_page(box, drawing)))
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
