// Results of a comparison in the forms that GitHub Actions shows.
#pragma once

#include <span>
#include <string>

#include "compare/compared_picture.h"

namespace poinsot {

// Workflow commands, one line each: an error for each of the worst pictures that fail, at most
// nine, and the number of the others. Source: GitHub Docs, "Workflow commands for GitHub Actions";
// GitHub shows ten annotations of a step.
std::string github_annotations(std::span<const ComparedPicture> pictures);

// A job summary in Markdown: the counts, and a table of the pictures that differ.
std::string github_summary(const std::string& title, std::span<const ComparedPicture> pictures);

}  // namespace poinsot
