// Results of a comparison in JSON.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "report/compared_picture.h"

namespace poinsot {

// An object: whether all pass, what was allowed, and each picture with what was counted and, where
// likeness was `measured`, with its SSIM and FLIP; else those are null.
std::string json_report(std::span<const ComparedPicture> pictures,
                        const std::optional<CompareLimits>& limits, bool measured);

}  // namespace poinsot
