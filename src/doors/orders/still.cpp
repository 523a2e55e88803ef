#include "orders/still.h"

#include <utility>

#include "error/error.h"
#include "production/stills/journal_request.h"

namespace poinsot {

StillOrder still_order(SceneRequest scene, const GivenOptions& given, const std::string& output,
                       const Task& task) {
    const library::PaperOptions& paper = given.paper;
    if (paper.keep_text && paper.journal.empty())
        throw InputError(
            "--keep-text: only --journal leaves text out; add --journal, or leave it out");
    scene.print = print_choices(paper);
    if (!paper.journal.empty()) apply_journal_style(paper.keep_text, scene, task);
    if (is_vector_name(output) && !scene.print.dpi) scene.print.dpi = default_dpi;
    if (given.time_s) scene.times_s = {*given.time_s};
    StillRequest still{.output = output,
                       .time_s = given.time_s,
                       .print = scene.print,
                       .bit_depth = given.depth,
                       .vectors = given.vectors,
                       .when = given.clearest ? StillTime::clearest : StillTime::of_scene};
    return {std::move(scene), std::move(still)};
}

}  // namespace poinsot
