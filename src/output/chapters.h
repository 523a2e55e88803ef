// Named sections of a film, in containers that can carry them. Included only inside output/.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/frame_sink.h"
#include "output/libav.h"

namespace poinsot {

// Before the header is written. Throws EnvironmentError if memory has run out.
void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate);

// Chapters as a text that a film under way carries, and back; what is no such text has none.
std::string chapters_text(std::span<const FilmChapter> chapters);
std::vector<FilmChapter> parse_chapters(std::string_view text);

// Those of a film that ends after n_frames.
std::vector<FilmChapter> first_chapters(std::span<const FilmChapter> chapters,
                                        std::int64_t n_frames);

}  // namespace poinsot
