#include "output/chapters.h"

#include "error/error.h"

extern "C" {
#include <libavutil/mem.h>
}

namespace poinsot {

void add_chapters(AVFormatContext& context, std::span<const FilmChapter> chapters,
                  const FrameRate& rate) {
    for (const FilmChapter& chapter : chapters) {
        // FFmpeg frees what hangs on the context.
        auto* const grown = static_cast<AVChapter**>(
            av_realloc_array(context.chapters, context.nb_chapters + 1, sizeof(AVChapter*)));
        if (grown == nullptr) throw EnvironmentError("no memory for a film's chapters");
        context.chapters = grown;
        auto* const added = static_cast<AVChapter*>(av_mallocz(sizeof(AVChapter)));
        if (added == nullptr) throw EnvironmentError("no memory for a film's chapters");
        context.chapters[context.nb_chapters++] = added;
        added->id = context.nb_chapters;
        added->time_base = {static_cast<int>(rate.denominator), static_cast<int>(rate.numerator)};
        added->start = chapter.first_frame;
        added->end = chapter.end_frame;
        av_dict_set(&added->metadata, "title", chapter.title.c_str(), 0);
    }
}

}  // namespace poinsot
