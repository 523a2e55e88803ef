// Results of a comparison in JSON.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "report/compared_picture.h"

namespace poinsot {

// A JSON object: whether all pictures pass, the limits, and for each picture the counts, SSIM and
// FLIP; the last two are null unless likeness was `measured`.
std::string json_report(std::span<const ComparedPicture> pictures,
                        const std::optional<CompareLimits>& limits, bool measured);

}  // namespace poinsot
