#include "production/vectors/journal.h"

#include <fmt/format.h>

#include <array>

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

// Defaults if a page gives no size: 8 pt, 6 pt, 0.5 pt.
constexpr std::array<Journal, 5> journal_rows{
    {{"aip",
      "AIP Publishing (American Journal of Physics, Chaos, …): 85 mm, at most 170; type of 8 pt, "
      "lines of 0.5 pt and more, fonts embedded; colour is free online",
      85.0, 170.0, 8.0, 6.0, 0.5,
      "asastore.aip.org/authors/preparing-graphics, read 2026-11-23: widths, type, lines, fonts; "
      "aapt.org's page for AJP says 86 mm and 8 pt; neither gives a size for sub- and "
      "superscripts"},
     {"aps",
      "American Physical Society (Physical Review): 86 mm, at most 178; type of 8 pt, lines of 0.5 "
      "pt and more; colour is free online, and must be clear in grey in print",
      86.0, 178.0, 8.0, 6.0, 0.5,
      "authors.aps.org/tips.html, read 2026-11-23: colour; widths and lines (0.18 mm) as quoted "
      "elsewhere, not verified; the type size is our choice"},
     {"elsevier",
      "Elsevier: 90 mm, at most 190; type of 7 pt, sub- and superscripts of 6 pt and more; RGB",
      90.0, 190.0, 7.0, 6.0, 0.5,
      "elsevier.com, sizing of artwork, read 2026-11-23: type, sub- and superscripts; widths as "
      "quoted elsewhere, not verified; line widths are our choice"},
     {"iop",
      "IOP Publishing: 85 mm, at most 150; type of 8 to 12 pt; lines of 0.5 pt and more; colours "
      "must differ in grey",
      85.0, 150.0, 8.0, 6.0, 0.5,
      "publishingsupport.iopscience.iop.org, figures for journal articles, read 2026-11-23: "
      "widths, type, colour; line widths are our choice"},
     {"springer",
      "Springer: 84 mm, at most 174; lettering of 8 to 12 pt, lines of 0.3 pt and more (0.5 here), "
      "fonts embedded; colour is free online, and must be clear in grey",
      84.0, 174.0, 8.0, 6.0, 0.5,
      "Springer's artwork guidelines as journals repeat them (interdisciplinarysciences.org, "
      "cqm.rs), read 2026-11-23: lettering, lines, fonts, colour; widths not verified"}}};

}  // namespace

std::span<const Journal> journals() { return journal_rows; }

const Journal& journal_named(std::string_view name) {
    if (const Journal* row = find_row(journal_rows, name)) return *row;
    throw InputError(unknown("journal", name, names_of(journal_rows)));
}

void set_least_sizes(const Journal& journal, PrintChoices& print) {
    print.journal = journal.name;
    print.least_type_pt = journal.least_type_pt;
    print.least_script_pt = journal.least_script_pt;
    print.least_line_pt = journal.least_line_pt;
}

void set_journal(const Journal& journal, PrintChoices& print) {
    set_least_sizes(journal, print);
    if (!print.width_mm) print.width_mm = journal.column_mm;
    if (print.width_mm && *print.width_mm > journal.page_mm)
        throw InputError(fmt::format(
            "--width-mm {:g}: a page of {} is {:g} mm wide, a column {:g}; give at most that",
            *print.width_mm, journal.name, journal.page_mm, journal.column_mm));
}

}  // namespace poinsot
