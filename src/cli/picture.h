// Pictures of a session: stage, context and renderer together, for the commands that draw.
#pragma once

#include "cli/options.h"
#include "cli/session.h"
#include "drawing/stage.h"
#include "image/image.h"
#include "render/renderer.h"

namespace poinsot {

struct PictureSpan {
    double first_time_s = 0.0;
    double last_time_s = 0.0;
};

// The context that the command line asks for.
OffscreenContext make_context(const Options& options);

class PictureMaker {
 public:
    PictureMaker(const Session& session, const Options& options, const PictureSpan& span);

    // The picture of an instant, drawn into an image whose memory is reused.
    void draw(double time_s, Image& image);

    const ContextInfo& context_info() const { return context_.info(); }

 private:
    Stage stage_;
    OffscreenContext context_;
    Renderer renderer_;
};

}  // namespace poinsot
