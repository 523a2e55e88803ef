// Makes a film or sequence from a session.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "encoding/frame_sink.h"
#include "production/session/session.h"
#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot {

struct FilmRequest {
    std::string output{};                                           // empty: output/<scene>.mp4
    std::optional<std::pair<std::int64_t, std::int64_t>> frames{};  // inclusive; empty: all
    // If not 0, only the first n_shown of those frames of a film, byte-identical to a run that was
    // interrupted after them.
    std::int64_t n_shown = 0;
    // Part K of N of those frames, both from 1; empty: all of them.
    std::optional<std::pair<std::int64_t, std::int64_t>> part{};
    // The film is one slide: its first and last frames are encoded independently of the others, so
    // that films that share such a frame decode to the same pixels there.
    bool is_slide = false;
};

class FilmJob {
 public:
    // The session must outlive it. Throws InputError for frames outside of the film.
    FilmJob(const Session& session, FilmRequest request);

    const FilmPlan& film() const { return film_; }

    // Number of requested frames, of which a part draws its share.
    std::int64_t n_frames() const { return last_ - first_ + 1; }

    // Draws and writes the film; continues an interrupted run of the same film. Throws InputError
    // and EnvironmentError.
    void make(LazyRenderer& renderer, const Task& task) const;

    // Throws InputError and EnvironmentError if they cannot be written because of what is there.
    void check_sidecars(const std::filesystem::path& pattern) const;

    // Writes the chapters and captions beside a film or sequence that exists. Throws
    // EnvironmentError.
    void write_sidecars(const std::filesystem::path& pattern, const Task& task) const;

 private:
    OutputPlan output_plan(const std::filesystem::path& path) const;
    bool take_part(OutputPlan& plan, const Task& task) const;
    void draw(PictureMaker& pictures, const OutputPlan& plan, const Task& task) const;
    void check_beside(const OutputPlan& plan) const;
    void write_beside(OutputPlan plan, const Task& task) const;

    const Session* session_;
    FilmRequest request_;
    FilmPlan film_;
    std::int64_t first_, last_;
};

}  // namespace poinsot
