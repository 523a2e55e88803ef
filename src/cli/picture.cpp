#include "cli/picture.h"

#include <fmt/format.h>

#include "error/error.h"
#include "error/nearest.h"

namespace poinsot {

namespace {

StageOptions stage_options(const Scene& scene, const PictureSpan& span) {
    StageOptions options;
    options.width_px = scene.film.width_px;
    options.height_px = scene.film.height_px;
    options.first_time_s = span.first_time_s;
    options.last_time_s = span.last_time_s;
    return options;
}

}  // namespace

OffscreenContext make_context(const Options& options) {
    Backend backend = Backend::automatic;
    if (options.backend == "osmesa") {
        backend = Backend::osmesa;
    } else if (options.backend == "egl") {
        backend = Backend::egl;
    } else if (options.backend != "auto") {
        throw InputError(fmt::format("--backend {}: unknown; choose auto, osmesa or egl",
                                     printable(options.backend)));
    }
    return OffscreenContext(backend,
                            options.portable ? Portability::portable : Portability::native);
}

PictureMaker::PictureMaker(const Session& session, const Options& options, const PictureSpan& span)
    : stage_(session.scene, session.motion, stage_options(session.scene, span)),
      context_(make_context(options)),
      renderer_(context_) {}

void PictureMaker::draw(double time_s, Image& image) {
    renderer_.render_into(stage_.at(time_s), image);
}

}  // namespace poinsot
