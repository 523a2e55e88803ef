// A page that shows compared pictures side by side, swapped, blinking, with a slider, and their
// differences alone or laid over the picture. It loads nothing from a network.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "compare/compared_picture.h"
#include "compare/report_pictures.h"

namespace poinsot {

// Two folders, as given on the command line, whose pictures can be approved.
struct ComparedFolders {
    std::string baselines, results;
};

// Returns the page, in the given order; see sort_by_severity. Pictures with the same outcome and
// the same changes are one group. Equal pairs have no pictures. With `folders`, the page offers the
// commands that approve pictures. Takes the pictures that have none yet.
std::string html_report(const std::string& title, std::span<ComparedPicture> pictures,
                        ReportPictures& shown, const std::optional<ComparedFolders>& folders = {});

}  // namespace poinsot
