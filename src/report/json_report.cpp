#include "report/json_report.h"

#include "text/json_text.h"

namespace poinsot {

std::string json_report(std::span<const ComparedPicture> pictures,
                        const std::optional<CompareLimits>& limits, bool measured) {
    std::vector<std::string> rows;
    for (const ComparedPicture& p : pictures) {
        const Comparison& m = p.measured;
        JsonObject row;
        row.add("name", p.name).add("outcome", name_of(p.outcome));
        row.add("passes", p.passes()).add("reason", p.reason);
        row.json("expected_size", json_numbers(m.expected_width, m.expected_height));
        row.json("actual_size", json_numbers(m.actual_width, m.actual_height));
        row.add("n_pixels", m.n_pixels).add("n_differing", m.n_differing);
        row.add("n_over_level", m.n_over_level);
        row.add("largest_difference", m.largest_difference);
        row.add("mean_difference", m.mean_difference);
        // Equal pictures need no measuring.
        const bool equal = measured && m.n_pixels > 0 && m.n_differing == 0;
        const std::optional<Likeness> likeness = equal ? Likeness{} : m.likeness;
        row.json("ssim", likeness ? json_number(likeness->ssim) : "null");
        row.json("flip", likeness ? json_number(likeness->flip) : "null");
        rows.push_back(row.line());
    }
    const std::string allowed = limits ? JsonObject()
                                             .add("differing_share", limits->differing_share)
                                             .add("level", limits->level)
                                             .add("over_level_share", limits->over_level_share)
                                             .line()
                                       : "null";
    return JsonObject()
        .add("passes", all_pass(pictures))
        .json("limits", allowed)
        .json("pictures", json_lines(rows, 2))
        .lines();
}

}  // namespace poinsot
