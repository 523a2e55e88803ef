// Pictures of a session in pixels: context and renderer, for the commands that draw.
#pragma once

#include <optional>
#include <string_view>

#include "image/image.h"
#include "production/records/record.h"
#include "production/session/picture_setting.h"
#include "production/session/session.h"
#include "render/renderer.h"
#include "scene/film_clock.h"
#include "shapes/crop.h"

namespace poinsot {

// The context on which pictures are drawn.
struct ContextChoice {
    Backend backend = Backend::automatic;
    Portability portability = Portability::native;
};
// From the values of --backend (auto, osmesa, egl or gpu) and --portable. Throws InputError for a
// backend that does not exist, and for portable pictures by a graphics card.
ContextChoice context_choice(std::string_view backend, bool portable);
// Throws EnvironmentError if the machine has no such context.
OffscreenContext make_context(const ContextChoice& choice,
                              ShaderCompilation compilation = ShaderCompilation::thorough);

// The context and the renderer, with its shaders, that all scenes of a command share. Opened on
// first use.
class LazyRenderer {
 public:
    explicit LazyRenderer(const ContextChoice& choice = {}) : choice_(choice) {}

    // Call before the context is opened: a single small picture takes less time than the
    // optimisation of shaders.
    void compile_quickly() { compilation_ = ShaderCompilation::quick; }

    // Throw as make_context does.
    const OffscreenContext& context();
    Renderer& renderer();
    const ContextChoice& choice() const { return choice_; }
    bool is_open() const { return context_.has_value(); }
    // Whether it draws byte-identical pictures on every processor.
    bool is_portable() const { return choice_.portability == Portability::portable; }

 private:
    ContextChoice choice_;
    ShaderCompilation compilation_ = ShaderCompilation::thorough;
    std::optional<OffscreenContext> context_;
    std::optional<Renderer> renderer_;
};

class PictureMaker {
 public:
    // Refers to the picture.
    PictureMaker(const PreparedPicture& picture, LazyRenderer& renderer);
    PictureMaker(PreparedPicture&& picture, LazyRenderer& renderer) = delete;
    // With the settings of the scene's quality. Throws for a scene without a picture before it
    // opens a context.
    PictureMaker(const Session& session, LazyRenderer& renderer, const PictureSpan& span);
    // Uses a context, which must outlive it.
    PictureMaker(const Session& session, const OffscreenContext& context, const PictureSpan& span,
                 const PictureSetting& setting);
    PictureMaker(const PictureMaker&) = delete;
    PictureMaker& operator=(const PictureMaker&) = delete;

    // Draws a moment of the film into an image, whose memory is reused.
    void draw(const FilmTime& moment, Image& image);

    // Draws an area of a drawing of the stage, in pixels of the final picture.
    void draw_part(const Drawing& whole, const PixelArea& area, Image& image);
    void draw_part(const Drawing& whole, const PixelArea& area, DeepImage& image);

    int width_px() const { return stage().context().options.width_px / picture_->samples; }
    int height_px() const { return stage().context().options.height_px / picture_->samples; }
    int samples_a_pixel() const { return picture_->samples * picture_->samples; }

    const ContextInfo& context_info() const { return context_->info(); }
    const Stage& stage() const { return picture_->stage; }
    const PictureBound& bound() const { return picture_->bound; }

 private:
    std::optional<PreparedPicture> own_;
    const PreparedPicture* picture_;
    const OffscreenContext* context_;
    std::optional<Renderer> created_renderer_;
    Renderer* renderer_;
    Image large_;
    DeepImage deep_large_;
};

// The record of pictures of a session, without time or frames.
Record record_of(const Session& session, const PictureMaker& pictures, bool portable);

}  // namespace poinsot
