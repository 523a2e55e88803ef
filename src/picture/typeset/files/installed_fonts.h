// The fonts that are installed on this computer.
#pragma once

#include "typeset/files/font_search.h"
#include "typeset/font_source.h"

namespace poinsot {

FontSource installed_fonts(FontSearch search = {});

}  // namespace poinsot
