#include "production/vectors/vector_still.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/style/picture_quality.h"
#include "error/error.h"
#include "production/vectors/latex_figure.h"
#include "system/sha256.h"
#include "text/nearest.h"
#include "text/printable.h"
#include "typeset/plain_text.h"
#include "vector/lettering.h"
#include "vector/pdf.h"
#include "vector/picture.h"
#include "vector/svg.h"

namespace poinsot {

namespace {

enum class Lettering { font, paths, latex };

// The value of an option's choice, by its name.
template <typename Value>
struct Named {
    std::string_view name;
    Value value;
};
constexpr Named<vector::Shading> shadings[] = {{"none", vector::Shading::none},
                                               {"tone", vector::Shading::tone},
                                               {"picture", vector::Shading::picture}};
constexpr Named<Lettering> letterings[] = {
    {"font", Lettering::font}, {"paths", Lettering::paths}, {"latex", Lettering::latex}};

template <typename Table>
auto value_named(std::string_view option, const Table& table, const std::string& name) {
    if (const auto* row = find_row(table, name)) return row->value;
    throw InputError(fmt::format("{} {}: unknown{}", option, printable(name),
                                 choose_instead(name, names_of(table))));
}
vector::Shading shading_named(const std::string& name) {
    return value_named("--shading", shadings, name);
}
Lettering lettering_named(const std::string& name) {
    return value_named("--text", letterings, name);
}

}  // namespace

PrintChoices on_paper(PrintChoices print, int width_px, int height_px) {
    if (!print.dpi) print.dpi = default_dpi;
    const auto size = print_size_of(print, width_px, height_px);
    const double longest_px = std::max(size->width_px, size->height_px);
    if (longest_px > longest_inches * *print.dpi)
        throw InputError(fmt::format(
            "a side of {:.0f} mm: a page has {:.0f} mm at most; make it smaller and print it "
            "larger: vectors stay sharp",
            longest_px / *print.dpi * mm_per_inch, longest_inches * mm_per_inch));
    if (print.width_mm)
        print.dpi = size->width_px / *print.width_mm * mm_per_inch;
    else if (print.height_mm)
        print.dpi = size->height_px / *print.height_mm * mm_per_inch;
    print.dpi = std::clamp(*print.dpi, least_dpi, most_dpi);
    return print;
}

void check_vector_choices(const VectorChoices& choices) {
    shading_named(choices.shading);
    lettering_named(choices.text);
}

bool has_pixels(const VectorChoices& choices) {
    return shading_named(choices.shading) == vector::Shading::picture;
}

PictureSetting vector_setting(const Scene& scene, const PrintChoices& print) {
    // Vectors have no quality, but a scene's must be one.
    at_scene_key(scene, "film.quality", [&] { picture_quality_named(scene.film.quality); });
    const auto paper = print_size_of(on_paper(print, scene.film.width_px, scene.film.height_px),
                                     scene.film.width_px, scene.film.height_px);
    PictureSetting setting;
    setting.put_on(*paper);
    return setting;
}

std::string title_of(const Scene& scene) {
    if (scene.title.empty()) return scene.name;
    return at_scene_key(scene, "title", [&] { return plain_text(scene.title); });
}

VectorStill vector_still(const std::filesystem::path& path, const std::string& title,
                         const Drawing& drawing, const VectorChoices& choices, Record record,
                         const vector::DrawPixels& draw_pixels) {
    const double dpi = record.dpi.value_or(default_dpi);
    vector::SheetOfPaper page =
        vector::paper_of(drawing, {.pt_per_px = pt_per_inch / dpi,
                                   .shading = shading_named(choices.shading),
                                   .draw_pixels = draw_pixels});
    constexpr double um_per_pt = 1000.0 * mm_per_inch / pt_per_inch;
    VectorStill still;
    still.off_um = page.off_pt * um_per_pt;
    const Lettering lettering = lettering_named(choices.text);
    if (lettering == Lettering::paths) page = vector::with_outlined_type(std::move(page));
    if (lettering == Lettering::latex) {
        const std::vector<vector::Type> type = vector::take_type(page);
        still.latex = latex_figure(page, type, path, still.latex_gaps);
    }
    record.bounds = fmt::format("{}; paths within {:.2g} um of what they show, before rounding",
                                record.bounds, still.off_um);
    if (is_svg_name(path)) {
        record.page = hash_of_svg(vector::svg_of(page, title, "record"), "record");
        still.bytes = vector::svg_of(page, title, sealed_text(record));
    } else {
        std::string pdf = vector::pdf_of(page);
        record.page = sha256_of(pdf);
        still.bytes =
            vector::with_pdf_text(std::move(pdf), title, pdf_text_name, sealed_text(record));
    }
    return still;
}

}  // namespace poinsot
