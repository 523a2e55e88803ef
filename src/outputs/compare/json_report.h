// Results of a comparison in JSON.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "compare/compared_picture.h"

namespace poinsot {

// A JSON object: whether all pictures pass, the limits of the command line (null: each picture's
// own), and for each picture its outcome, what its record says that changed (null: unknown), its
// limits, counts, SSIM and FLIP (null: not measured), and of films the frames that differ.
std::string json_report(std::span<const ComparedPicture> pictures,
                        const std::optional<CompareLimits>& limits);

}  // namespace poinsot
