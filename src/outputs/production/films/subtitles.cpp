#include "production/films/subtitles.h"

#include "production/films/sidecar_place.h"
#include "system/files/atomic_file.h"
#include "system/files/file_kind.h"

namespace poinsot {

std::filesystem::path subtitles_path(const std::filesystem::path& film) {
    std::string stem = film.stem().string();
    if (suffix_of(film) != ".mp4") stem += film.extension().string();
    return film.parent_path() / (stem + ".vtt");
}

void check_subtitles_place(const std::filesystem::path& film) {
    check_sidecar(subtitles_path(film), any_subtitles_head, "captions");
}

void write_subtitles(const std::filesystem::path& film, std::span<const FilmSubtitle> subtitles) {
    if (subtitles.empty())
        return remove_stale_sidecar(subtitles_path(film), subtitles_head(film.filename().string()));
    check_subtitles_place(film);
    write_whole(subtitles_path(film), subtitles_text(film.filename().string(), subtitles));
}

}  // namespace poinsot
