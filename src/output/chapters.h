// Named sections of a film, in containers that can carry them. Included only inside output/.
#pragma once

#include <span>

#include "output/frame_sink.h"
#include "output/libav.h"

namespace poinsot {

// Before the header is written. Throws EnvironmentError if memory has run out.
void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate);

}  // namespace poinsot
