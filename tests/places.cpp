#include "places.h"

namespace poinsot {

std::filesystem::path source_folder() { return POINSOT_SOURCE_DIR; }

}  // namespace poinsot
