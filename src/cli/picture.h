// Pictures of a session: stage, context and renderer together, for the commands that draw.
#pragma once

#include <memory>

#include "cli/options.h"
#include "cli/session.h"
#include "drawing/stage.h"
#include "image/image.h"
#include "output/frame_sink.h"
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

    // The picture of an instant; it stays valid until the next call.
    const Image& at(double time_s);

 private:
    Stage stage_;
    OffscreenContext context_;
    Renderer renderer_;
    Image image_;
};

// The sink for a film, with encoding in a thread of its own. Throws InputError, EnvironmentError.
std::unique_ptr<FrameSink> open_film_sink(const OutputPlan& plan);

}  // namespace poinsot
