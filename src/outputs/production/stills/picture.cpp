#include "production/stills/picture.h"

#include <fmt/format.h>

#include <utility>

#include "error/error.h"
#include "image/downsample.h"
#include "text/printable.h"

namespace poinsot {

ContextChoice context_choice(std::string_view backend, bool portable) {
    ContextChoice choice;
    choice.portability = portable ? Portability::portable : Portability::native;
    if (backend == "osmesa") {
        choice.backend = Backend::osmesa;
    } else if (backend == "egl") {
        choice.backend = Backend::egl;
    } else if (backend == "gpu") {
        choice.backend = Backend::gpu;
        if (portable)
            throw InputError(
                "--backend gpu: portable pictures are drawn in software; leave out --portable or "
                "--backend");
    } else if (backend != "auto") {
        throw InputError(fmt::format("--backend {}: unknown; choose auto, osmesa, egl or gpu",
                                     printable(backend)));
    }
    return choice;
}

OffscreenContext make_context(const ContextChoice& choice, ShaderCompilation compilation) {
    return OffscreenContext(choice.backend, choice.portability, compilation);
}

const OffscreenContext& LazyRenderer::context() {
    if (!context_) context_.emplace(make_context(choice_, compilation_));
    return *context_;
}

Renderer& LazyRenderer::renderer() {
    if (!renderer_) renderer_.emplace(context());
    return *renderer_;
}

namespace {

// Throws EnvironmentError if the process may not take the memory for such a picture.
LazyRenderer& with_memory_for(const Stage& stage, LazyRenderer& renderer) {
    // Of a large picture, bands are drawn one by one.
    const std::int64_t n_samples = std::min<std::int64_t>(
        std::int64_t{stage.context().options.width_px} * stage.context().options.height_px,
        32'000'000);
    // Measured (2026-11-27): 20 bytes a sample.
    const std::int64_t MiB = 35 * n_samples >> 20;
    MemoryNeed need = memory_of_drawing();
    need.address_MiB += MiB;
    need.data_MiB += MiB;
    check_memory("drawing this picture", need);
    return renderer;
}

}  // namespace

PictureMaker::PictureMaker(const PreparedPicture& picture, LazyRenderer& renderer)
    : picture_(&picture),
      context_(&with_memory_for(picture.stage, renderer).context()),
      renderer_(&renderer.renderer()) {}

PictureMaker::PictureMaker(const Session& session, LazyRenderer& renderer, const PictureSpan& span)
    : own_(std::in_place, session, span, setting_of(session.scene)),
      picture_(&*own_),
      context_(&with_memory_for(picture_->stage, renderer).context()),
      renderer_(&renderer.renderer()) {}

PictureMaker::PictureMaker(const Session& session, const OffscreenContext& context,
                           const PictureSpan& span, const PictureSetting& setting)
    : own_(std::in_place, session, span, setting),
      picture_(&*own_),
      context_(&context),
      created_renderer_(context),
      renderer_(&*created_renderer_) {}

void PictureMaker::draw(const FilmTime& moment, Image& image) {
    if (picture_->samples == 1) {
        renderer_->render_into(stage().at(moment), image);
        return;
    }
    renderer_->render_into(stage().at(moment), large_);
    downsample_into(large_, picture_->samples, image);
}

void PictureMaker::draw_part(const Drawing& whole, const PixelArea& area, Image& image) {
    const PixelArea drawn{picture_->samples * area.x_px, picture_->samples * area.y_px,
                          picture_->samples * area.width_px, picture_->samples * area.height_px};
    if (picture_->samples == 1) return renderer_->render_into(cropped(whole, drawn), image);
    renderer_->render_into(cropped(whole, drawn), large_);
    image = downsampled(large_, picture_->samples);
}

void PictureMaker::draw_part(const Drawing& whole, const PixelArea& area, DeepImage& image) {
    if (picture_->samples == 1) return renderer_->render_into(cropped(whole, area), image);
    const PixelArea drawn{picture_->samples * area.x_px, picture_->samples * area.y_px,
                          picture_->samples * area.width_px, picture_->samples * area.height_px};
    renderer_->render_into(cropped(whole, drawn), deep_large_);
    downsample_into(deep_large_, picture_->samples, image);
}

Record record_of(const Session& session, const PictureMaker& pictures, bool portable) {
    Record record =
        record_of(session, pictures.stage(), in_words(pictures.bound(), session.accuracy.asked_px));
    record_context(pictures.context_info(), portable, record);
    return record;
}

}  // namespace poinsot
