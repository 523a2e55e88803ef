// The tables of kept fonts that the page gave to the module.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "typeset/font_source.h"
#include "typeset/kept_font.h"

namespace poinsot {

// Adds a table, whose bytes last as long as the program.
void add_kept_font(std::string_view name, std::string_view table);

// The fonts of labels and captions from these tables; tables of other names are fallbacks, in
// order.
FontSource kept_fonts();

// The table of a font. throws: EnvironmentError if there is none.
const KeptFont& kept_font_named(std::string_view name);

}  // namespace poinsot
