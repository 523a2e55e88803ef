// Whether two records are of one film's parts, and if not, why.
#pragma once

#include <string>

#include "production/record.h"

namespace poinsot {

// Empty if they agree in everything but frame and hashes; else what differs, as the end of a
// sentence: "their scenes or settings differ: quality = "draft" and quality = "lecture"".
std::string difference_of(const Record& one, const Record& other);

}  // namespace poinsot
