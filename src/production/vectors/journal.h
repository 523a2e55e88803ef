// What publishers ask of a figure; --journal. From their author pages, with the day they were read.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "production/print_size.h"

namespace poinsot {

struct Journal {
    std::string_view name;
    std::string_view summary;      // who, and what they ask for
    double column_mm = 0.0;        // a figure of one column
    double page_mm = 0.0;          // the widest
    double least_type_pt = 8.0;    // of letters
    double least_script_pt = 6.0;  // of sub- and superscripts
    double least_line_pt = 0.5;
    std::string_view source;  // the page, the day, and what it does not say
};

std::span<const Journal> journals();

// Throws InputError with the nearest name and the list.
const Journal& journal_named(std::string_view name);

// Its name, and the least sizes that it asks for; ours where it asks for none.
void set_least_sizes(const Journal& journal, PrintChoices& print);

// Those, and one column's width where none is given. Throws InputError for a figure that is wider
// than its page.
void set_journal(const Journal& journal, PrintChoices& print);

}  // namespace poinsot
