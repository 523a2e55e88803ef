#include "drawing/style/picture_quality.h"

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

constexpr PictureQuality picture_quality_rows[] = {
    {"draft", 10.0, 1},
    {"lecture", 1.0, 1},
    {"print", 0.5, 2},
    {"reference", 0.1, 4},
};

}  // namespace

std::span<const PictureQuality> picture_qualities() { return picture_quality_rows; }

const PictureQuality& picture_quality_named(std::string_view name) {
    if (const PictureQuality* row = find_row(picture_quality_rows, name)) return *row;
    throw InputError(unknown("quality", name, names_of(picture_quality_rows)));
}

}  // namespace poinsot
