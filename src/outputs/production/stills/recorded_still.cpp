#include "production/stills/recorded_still.h"

#include "production/vectors/journal.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

StillRequest request_of(const Record& record) {
    StillRequest still{.time_s = record.time_s};
    // A halt shows one instant in many frames.
    if (record.frame) {
        still.frame = record.frame;
        still.time_s.reset();
    }
    still.print.dpi = record.dpi;
    still.print.type_pt = record.type_pt;
    if (!record.journal.empty()) set_least_sizes(journal_named(record.journal), still.print);
    still.names_fade = record.names == fading_names;
    still.bit_depth = record.bit_depth;
    if (!record.shading.empty()) still.vectors.shading = record.shading;
    if (!record.lettering.empty()) still.vectors.text = record.lettering;
    return still;
}

SessionRequest needs_of(const Record& record) {
    SessionRequest needs{.fonts = installed_fonts()};
    if (record.time_s) needs.times_s.push_back(*record.time_s);
    return needs;
}

}  // namespace poinsot
