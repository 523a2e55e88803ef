#include "production/films/sidecar_place.h"

#include <fmt/format.h>

#include "error/error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "text/printable.h"

namespace poinsot {

void check_sidecar(const std::filesystem::path& path, std::string_view beginning,
                   std::string_view contents) {
    if (kind_of_file(path) != FileKind::missing && !begins_with(path, beginning))
        throw InputError(fmt::format(
            "{}: exists and was not written by poinsot, and the film's {} would replace "
            "it; remove it, or name another output",
            printable(path.string()), contents));
    check_aside(path);
}

}  // namespace poinsot
