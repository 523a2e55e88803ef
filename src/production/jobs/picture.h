// Pictures of a session: stage, context and renderer, for the commands that draw.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/stage.h"
#include "drawing/stage_data.h"
#include "image/image.h"
#include "production/session/print_size.h"
#include "production/session/session.h"
#include "render/renderer.h"
#include "scene/film_clock.h"
#include "shapes/part.h"

namespace poinsot {

struct PictureSpan {
    double first_time_s = 0.0;
    double last_time_s = 0.0;
    std::optional<double> first_shown_s{};  // no picture is earlier; else the first
};

// The context on which pictures are drawn.
struct ContextChoice {
    Backend backend = Backend::automatic;
    Portability portability = Portability::native;
};
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

// Settings of a picture's quality; --quality selects some of these.
struct PictureSetting {
    double curve_tolerance = 1.0;  // in units of the scene's accuracy_px
    int samples = 1;               // supersampling: samples × samples per pixel
    double line_scale = 0.0;       // as in StageOptions, of the final picture
    LeastSizes least{};            // as in StageOptions, of the final picture

    // Uses the sizes of lines and text on paper.
    void put_on(const PrintSize& paper) {
        line_scale = paper.line_scale;
        least = paper.least;
    }
};

// The settings of the scene's quality, with the size on paper.
PictureSetting setting_of(const Scene& scene, const PrintChoices& print = {});

// The stage of pictures with this setting. The session must outlive it.
Stage stage_of(const Session& session, const PictureSpan& span, const PictureSetting& setting);

// What is drawn otherwise than asked for: as a ring, or as boxes, for want of a font.
void tell_stage_notes(const Stage& stage, const ProgressSink& progress);

// Upper bounds of position errors in the picture, in pixels of the final picture.
struct PictureBound {
    double motion_px = 0.0;            // see motion_error_px
    double curves_px = 0.0;            // polylines for curves
    std::vector<std::string> notes{};  // what is drawn for something else, as Stage has them
    double total_px() const { return motion_px + curves_px; }
};
PictureBound bound_of(const Session& session, const Stage& stage, int samples);

// "within 0.05 px of the truth (motion 1.6e-11 px, curves 0.05 px; 0.1 px asked)"
std::string in_words(const PictureBound& bound, double accuracy_px);

// Everything that the pictures of a session need except for the context. Preparing it takes most of
// the time of a small picture, and may be done by another thread. The session must outlive it.
struct PreparedPicture {
    // With the settings of the scene's quality.
    PreparedPicture(const Session& session, const PictureSpan& span, const PrintChoices& print);
    PreparedPicture(const Session& session, const PictureSpan& span, const PictureSetting& setting);

    int samples;
    Stage stage;
    PictureBound bound;
};

class PictureMaker {
 public:
    // Throws for a scene without a picture before it opens a context.
    PictureMaker(PreparedPicture staging, LazyRenderer& renderer);
    // With the settings of the scene's quality.
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

    int width_px() const { return stage().data().options.width_px / staging_.samples; }
    int height_px() const { return stage().data().options.height_px / staging_.samples; }
    int samples_a_pixel() const { return staging_.samples * staging_.samples; }

    const ContextInfo& context_info() const { return context_->info(); }
    const Stage& stage() const { return staging_.stage; }
    const PictureBound& bound() const { return staging_.bound; }

 private:
    PreparedPicture staging_;
    const OffscreenContext* context_;
    std::optional<Renderer> created_renderer_;
    Renderer* renderer_;
    Image large_;
    DeepImage deep_large_;
};

}  // namespace poinsot
