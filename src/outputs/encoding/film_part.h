// A part of a film: some of its frames, rendered by a separate process or machine; the joined parts
// are byte-identical to a single run. Parts begin where an encoder is restarted.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace poinsot {

// The metadata of a part, in addition to that of every film.
struct FilmPart {
    std::string format;                    // of the film, by its name in the table of formats
    std::int64_t number = 1, n_parts = 1;  // from 1
    std::int64_t n_before = 0;             // frames of the film that come before it
    std::int64_t n_frames = 0;             // of the part
    std::int64_t n_film_frames = 0;        // of the film
    // Sidecar text of the film without its first lines; empty: none.
    std::string chapters;

    bool operator==(const FilmPart&) const = default;
};

// Returns the frames of part K of N of a film that is encoded in chunks. If there are fewer chunks
// than parts, there are as many parts as chunks, and n_parts is that number; number is K even if it
// is larger. Precondition: all positive.
FilmPart part_of_film(std::int64_t number, std::int64_t n_parts, std::int64_t n_film_frames,
                      std::int64_t n_chunk_frames);

// Converts a part to the text in a file, and back; false for any other text.
std::string part_text(const FilmPart& part);
bool parse_part(std::string_view text, FilmPart& part);

}  // namespace poinsot
