// A page that shows compared pictures side by side, swapped, blinking, with a slider and as a
// difference. It is a single file that embeds the pictures and loads nothing from a network.
#pragma once

#include <span>
#include <string>

#include "report/compared_picture.h"

namespace poinsot {

// Returns the page, in the given order; see sort_by_severity. Pictures of equal pairs are omitted.
// Throws EnvironmentError if a picture was removed after the comparison.
std::string html_report(const std::string& title, std::span<const ComparedPicture> pictures);

}  // namespace poinsot
