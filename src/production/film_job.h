// A film or sequence, from a session to its file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "output/frame_sink.h"
#include "production/picture.h"
#include "production/session.h"
#include "production/telling.h"

namespace poinsot {

struct FilmRequest {
    std::string output{};                                           // empty: output/<scene>.mp4
    std::optional<std::pair<std::int64_t, std::int64_t>> frames{};  // inclusive; nothing: all
    // Of a film the first so many of those frames alone, with the bytes of a run that was
    // interrupted after them; 0: all.
    std::int64_t n_shown = 0;
};

class FilmJob {
 public:
    // The session must outlive it. Throws InputError for frames that the film does not have.
    FilmJob(const Session& session, FilmRequest request);

    const FilmPlan& film() const { return film_; }

    // Draws and writes it, from where an interrupted run of the same film ended. Throws InputError
    // and EnvironmentError.
    void make(Easel& easel, const Telling& telling) const;

 private:
    OutputPlan output_plan(const std::filesystem::path& path) const;

    const Session* session_;
    FilmRequest request_;
    FilmPlan film_;
    std::int64_t first_, last_;
};

}  // namespace poinsot
