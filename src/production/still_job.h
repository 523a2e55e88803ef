// One picture of a scene, from a session to its file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "production/output_place.h"
#include "production/picture.h"
#include "production/print_size.h"
#include "production/record.h"
#include "production/session.h"
#include "production/still_writer.h"
#include "production/telling.h"
#include "production/vectors/vector_still.h"

namespace poinsot {

struct StillRequest {
    std::string output{};            // empty: output/<scene>.png
    std::optional<double> time_s{};  // of the motion; nothing: where the scene says
    PrintChoices print{};
    int bit_depth = 8;  // of a component
    VectorChoices vectors{};
};

// A picture ready to be drawn. Any thread may make it.
class StillJob {
 public:
    // Throws InputError.
    StillJob(Session&& session, StillRequest request);
    StillJob(const StillJob&) = delete;
    StillJob& operator=(const StillJob&) = delete;

    std::int64_t n_pixels() const;
    // Whether its drawing opens the easel's context.
    bool opens_context() const {
        return !is_vector_name(request_.output) || has_pixels(request_.vectors);
    }
    // What its record says, but for what draws it and for the instant.
    Record record() const;

    // Draws it; the writer may still have it in hand. Throws InputError, EnvironmentError, and what
    // the writer throws of an earlier one.
    void draw(Easel& easel, StillWriter& writer, const Telling& telling);

    // Draws it into memory alone, as one of many; its record. Throws as draw does.
    Record draw_into(Easel& easel, Image& image);

 private:
    void draw_vectors(OutputPlace place, Record record, Easel& easel, const Telling& telling);

    Session session_;
    StillRequest request_;
    FilmMoment moment_;
    Staging staging_;
};

}  // namespace poinsot
