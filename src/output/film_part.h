// A part of a film: some of its frames, drawn by another process or machine than the others, that
// are joined to the bytes of one run. The seams lie where an encoder starts anew.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace poinsot {

// What a part says of itself, besides what every film says.
struct FilmPart {
    std::string format;                    // of the film, by its name in the table of formats
    std::int64_t number = 1, n_parts = 1;  // from 1
    std::int64_t n_before = 0;             // frames of the film that come before it
    std::int64_t n_frames = 0;             // of the part
    std::int64_t n_film_frames = 0;        // of the film
    // What lies beside the film, as text without its first lines; empty: nothing.
    std::string chapters;

    bool operator==(const FilmPart&) const = default;
};

// The frames of part K of N of a film that is encoded in chunks. Where there are fewer chunks than
// parts there are as many parts as chunks, and n_parts says so; number is K even where that is
// more. Precondition: all positive.
FilmPart part_of_film(std::int64_t number, std::int64_t n_parts, std::int64_t n_film_frames,
                      std::int64_t n_chunk_frames);

// As it stands in a file, and back; false for what is no such text.
std::string part_text(const FilmPart& part);
bool parse_part(std::string_view text, FilmPart& part);

}  // namespace poinsot
