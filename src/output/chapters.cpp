#include "output/chapters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "error/error.h"

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

// A line "FIRST END LENGTH " each, and the title of that many bytes, whatever is in it.
std::string chapters_text(std::span<const FilmChapter> chapters) {
    std::string text;
    for (const FilmChapter& chapter : chapters)
        text += fmt::format("{} {} {} {}\n", chapter.first_frame, chapter.end_frame,
                            chapter.title.size(), chapter.title);
    return text;
}

std::vector<FilmChapter> parse_chapters(std::string_view text) {
    std::vector<FilmChapter> chapters;
    while (!text.empty()) {
        std::array<std::int64_t, 3> numbers{};
        for (std::int64_t& number : numbers) {
            const char* const last = text.data() + text.size();
            const auto [end, error] = std::from_chars(text.data(), last, number);
            if (error != std::errc{} || number < 0 || end == last || *end != ' ') return {};
            text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
        }
        const auto length = static_cast<std::size_t>(numbers[2]);
        if (length >= text.size()) return {};
        chapters.push_back({std::string(text.substr(0, length)), numbers[0], numbers[1]});
        text.remove_prefix(length + 1);
    }
    return chapters;
}

std::vector<FilmChapter> first_chapters(std::span<const FilmChapter> chapters,
                                        std::int64_t n_frames) {
    std::vector<FilmChapter> first;
    for (FilmChapter chapter : chapters) {
        chapter.end_frame = std::min(chapter.end_frame, n_frames);
        if (chapter.first_frame < chapter.end_frame) first.push_back(chapter);
    }
    return first;
}

}  // namespace poinsot
