// A page that shows compared pictures side by side, swapped, blinking, under a slider and as a
// difference. One file: pictures are part of it, nothing comes from a network.
#pragma once

#include <span>
#include <string>

#include "report/compared_picture.h"

namespace poinsot {

// The page, in the order given; see sort_by_severity. Pictures of pairs that are the same are left
// out. Throws EnvironmentError if a picture has vanished since it was compared.
std::string html_report(const std::string& title, std::span<const ComparedPicture> pictures);

}  // namespace poinsot
