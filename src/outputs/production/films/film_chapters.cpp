// Which chapters a film has. No file: a page has them, too.
#include <algorithm>

#include "production/films/chapters.h"

namespace poinsot {

std::vector<FilmChapter> chapters_of(const Scene& scene, const FilmPlan& film, std::int64_t first,
                                     std::int64_t last) {
    std::vector<FilmChapter> chapters;
    for (std::size_t i = 0; i < scene.chapters.size(); ++i) {
        const bool is_last = i + 1 == scene.chapters.size();
        const std::int64_t begin = film.frame_at(scene.chapters[i].at_s);
        const std::int64_t end =
            is_last ? film.n_frames : film.frame_at(scene.chapters[i + 1].at_s);
        FilmChapter chapter;
        chapter.title = scene.chapters[i].title;
        chapter.first_frame = std::clamp(begin, first, last + 1) - first;
        chapter.end_frame = std::clamp(end, first, last + 1) - first;
        if (chapter.first_frame < chapter.end_frame) chapters.push_back(chapter);
    }
    return chapters;
}

}  // namespace poinsot
