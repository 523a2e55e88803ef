#include "program_run.h"

namespace poinsot::testing {

const std::string& program_path() {
    static const std::string path = POINSOT_PROGRAM;
    return path;
}

}  // namespace poinsot::testing
