#include "work/still.h"

#include <utility>

#include "production/stills/journal_request.h"

namespace poinsot {

StillOrder still_order(SceneRequest scene, StillRequest still, bool keeps_text,
                       const ProgressSink& progress) {
    scene.print = still.print;
    if (!still.print.journal.empty()) apply_journal_style(keeps_text, scene, progress);
    if (is_vector_name(still.output) && !scene.print.dpi) scene.print.dpi = default_dpi;
    if (still.time_s) scene.times_s = {*still.time_s};
    still.print = scene.print;
    return {std::move(scene), std::move(still)};
}

}  // namespace poinsot
