#include "encoding/film_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "text/numbers.h"

namespace poinsot {

namespace {

// Lines "NAME LENGTH", each followed by that many bytes of any content.
void append(std::string& text, std::string_view value) {
    text += fmt::format("{}\n{}\n", value.size(), value);
}

bool take(std::string_view& text, std::string& value) {
    std::int64_t size = 0;
    if (!take_count(text, size, '\n') || static_cast<std::size_t>(size) >= text.size())
        return false;
    value = text.substr(0, static_cast<std::size_t>(size));
    text.remove_prefix(static_cast<std::size_t>(size) + 1);
    return true;
}

}  // namespace

FilmPart part_of_film(std::int64_t number, std::int64_t n_parts, std::int64_t n_film_frames,
                      std::int64_t n_chunk_frames) {
    const std::int64_t n_chunks = (n_film_frames + n_chunk_frames - 1) / n_chunk_frames;
    FilmPart part;
    part.number = number;
    part.n_parts = std::min(n_parts, n_chunks);
    part.n_film_frames = n_film_frames;
    // Chunks are distributed evenly: n_chunks·k/N without the product, which might overflow.
    const std::int64_t each = n_chunks / part.n_parts, more = n_chunks % part.n_parts;
    const auto end_of = [&](std::int64_t k) {
        return std::min(n_film_frames, (each * k + std::min(k, more)) * n_chunk_frames);
    };
    if (number > part.n_parts) return part;
    part.n_before = end_of(number - 1);
    part.n_frames = end_of(number) - part.n_before;
    return part;
}

std::string part_text(const FilmPart& part) {
    std::string text = fmt::format("{} {} {} {} {}\n", part.number, part.n_parts, part.n_before,
                                   part.n_frames, part.n_film_frames);
    for (const std::string* value : {&part.format, &part.chapters}) append(text, *value);
    return text;
}

bool parse_part(std::string_view text, FilmPart& part) {
    const std::array<std::int64_t*, 5> numbers{&part.number, &part.n_parts, &part.n_before,
                                               &part.n_frames, &part.n_film_frames};
    for (std::int64_t* number : numbers)
        if (!take_count(text, *number, number == numbers.back() ? '\n' : ' ')) return false;
    for (std::string* value : {&part.format, &part.chapters})
        if (!take(text, *value)) return false;
    return text.empty() && part.number >= 1 && part.number <= part.n_parts && part.n_frames >= 1 &&
           part.n_before <= part.n_film_frames - part.n_frames;
}

}  // namespace poinsot
