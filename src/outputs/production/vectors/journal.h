// Publishers' requirements for figures; --journal. From their author pages, with the date of
// access.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "production/session/print_size.h"

namespace poinsot {

struct Journal {
    std::string_view name;
    std::string_view summary;      // publisher and requirements
    double column_mm = 0.0;        // width of a single-column figure
    double page_mm = 0.0;          // greatest width
    double least_type_pt = 8.0;    // of letters
    double least_script_pt = 6.0;  // of sub- and superscripts
    double least_line_pt = 0.5;
    std::string_view source;  // page, date, and requirements that it does not give
};

std::span<const Journal> journals();

// Throws InputError with the nearest name and the list.
const Journal& journal_named(std::string_view name);

// Sets its name and the least sizes that it requires; the default sizes if it requires none.
void set_least_sizes(const Journal& journal, PrintChoices& print);

// The same, and the width of one column if no width is given. Throws InputError for a figure that
// is wider than its page.
void set_journal(const Journal& journal, PrintChoices& print);

}  // namespace poinsot
