#include "cli/requests.h"

#include <fmt/format.h>

#include "error/error.h"
#include "text/printable.h"

namespace poinsot {

SceneRequest scene_request_of(const Options& options) {
    SceneRequest request;
    request.file = options.arguments.at(0);
    request.overrides = options.overrides;
    request.outside = options.allow_outside ? OutsideFiles::allowed : OutsideFiles::refused;
    request.print = options.print;
    request.times_s = options.times_s;
    request.quiet = options.quiet;
    if (options.time_s) request.times_s.push_back(*options.time_s);
    return request;
}

ContextChoice context_choice_of(const Options& options) {
    ContextChoice choice;
    choice.portability = options.portable ? Portability::portable : Portability::native;
    if (options.backend == "osmesa") {
        choice.backend = Backend::osmesa;
    } else if (options.backend == "egl") {
        choice.backend = Backend::egl;
    } else if (options.backend != "auto") {
        throw InputError(fmt::format("--backend {}: unknown; choose auto, osmesa or egl",
                                     printable(options.backend)));
    }
    return choice;
}

}  // namespace poinsot
