#include "production/session/print_size.h"

#include <fmt/format.h>

#include <cmath>

#include "drawing/stage/type/type_sizes.h"
#include "error/error.h"
#include "image/png.h"

namespace poinsot {

namespace {

constexpr int least_side_px = 16;

void check_between(const char* option, std::optional<double> value, double least, double most,
                   const char* unit) {
    if (!value || (*value >= least && *value <= most)) return;
    throw InputError(
        fmt::format("{} {:g}: give {:g} to {:g} {}", option, *value, least, most, unit));
}

// The pixels of a side; `option` is the option that determines it, for messages.
int side_px(const char* option, double given_mm, double side_mm, double dpi) {
    const double px = std::round(side_mm / mm_per_inch * dpi);
    if (px >= least_side_px && px <= largest_banded_png_side_px) return static_cast<int>(px);
    throw InputError(
        fmt::format("{} {:g} at {:g} dpi makes a side of {:.0f} pixels; a picture has {} to {} per "
                    "side: change {} or --dpi",
                    option, given_mm, dpi, px, least_side_px, largest_banded_png_side_px, option));
}

}  // namespace

std::optional<PrintSize> print_size_of(const PrintChoices& print, int scene_width_px,
                                       int scene_height_px) {
    if (!print.width_mm && !print.height_mm && !print.dpi && !print.type_pt) return std::nullopt;
    check_between("--width-mm", print.width_mm, 1.0, 1e5, "millimetres");
    check_between("--height-mm", print.height_mm, 1.0, 1e5, "millimetres");
    check_between("--dpi", print.dpi, least_dpi, most_dpi, "dots per inch");
    check_between("--type-pt", print.type_pt, 1.0, 1'000.0, "points");

    if (print.type_pt && *print.type_pt < print.least_type_pt)
        throw InputError(
            fmt::format("--type-pt {:g}: type on paper has {:g} points or more; give a larger size",
                        *print.type_pt, print.least_type_pt));

    const double dpi = print.dpi.value_or(default_dpi);
    PrintSize size{scene_width_px, scene_height_px};
    const double shape = 1.0 * scene_width_px / scene_height_px;
    if (print.width_mm || print.height_mm) {
        const double width_mm = print.width_mm ? *print.width_mm : *print.height_mm * shape;
        const double height_mm = print.height_mm ? *print.height_mm : *print.width_mm / shape;
        const auto side = [&](bool is_width, double side_mm) {
            const bool by_width = is_width ? print.width_mm.has_value() : !print.height_mm;
            return side_px(by_width ? "--width-mm" : "--height-mm",
                           by_width ? *print.width_mm : *print.height_mm, side_mm, dpi);
        };
        size.width_px = side(true, width_mm);
        size.height_px = side(false, height_mm);
    }
    size.line_scale = print.type_pt.value_or(default_type_pt) / label_size * dpi / pt_per_inch;
    size.least = LeastSizes{print.least_type_pt, print.least_script_pt, print.least_line_pt}.times(
        dpi / pt_per_inch);
    size.px_per_pt = dpi / pt_per_inch;
    size.pixels_per_metre = 1000.0 * dpi / mm_per_inch;
    return size;
}

}  // namespace poinsot
