#include "drawing/style/picture_quality.h"

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

constexpr PictureQuality picture_quality_rows[] = {
    {.name = "draft", .curve_tolerance = 10.0, .samples = 1},
    {.name = "lecture", .curve_tolerance = 1.0, .samples = 1},
    {.name = "print", .curve_tolerance = 0.5, .samples = 2},
    {.name = "reference", .curve_tolerance = 0.1, .samples = 4},
};

}  // namespace

std::span<const PictureQuality> picture_qualities() { return picture_quality_rows; }

const PictureQuality& picture_quality_named(std::string_view name) {
    if (const PictureQuality* row = find_row(picture_quality_rows, name)) return *row;
    throw InputError(unknown("quality", name, names_of(picture_quality_rows)));
}

}  // namespace poinsot
