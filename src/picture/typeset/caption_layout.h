// Breaks captions into lines and typesets them.
#pragma once

#include <vector>

#include "typeset/font_set.h"
#include "typeset/label_tree.h"
#include "typeset/type_box.h"
#include "typeset/typesetter.h"

namespace poinsot {

// Marks where the terms occur: words as whole words, also with a plural s; formulas as consecutive
// atoms of a formula, whose scripts agree; of two terms that begin at the same place the longer.
void tint_terms(const std::vector<CaptionTerm>& terms, Caption& caption);

struct SetCaption {
    TypeBox box;  // the first baseline is at y = 0; the pen starts at x = 0 on the widest line
    int n_lines = 0;
};

// Each line holds as many words as fit into style.max_width_px, and at least one. Baselines are at
// whole pixels. throws: LabelError for a character that the fonts lack.
SetCaption set_caption(const Caption& caption, const TypeStyle& style, FontSet& fonts);

}  // namespace poinsot
