// Whether two records belong to parts of the same film, and if not, why.
#pragma once

#include <string>

#include "production/records/record.h"

namespace poinsot {

// Empty if the records agree in everything but frame and hashes; else the difference, as the end of
// a sentence: "their scenes or settings differ: quality = "draft" and quality = "lecture"".
std::string difference_of(const Record& one, const Record& other);

}  // namespace poinsot
