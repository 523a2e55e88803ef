// One picture of a scene: prepared from a session, then drawn into a file or into memory.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "production/records/record.h"
#include "production/session/picture_setting.h"
#include "production/session/print_size.h"
#include "production/session/session.h"
#include "production/session/still_moment.h"
#include "production/session/task.h"
#include "production/stills/output_place.h"
#include "production/stills/picture.h"
#include "production/stills/still_writer.h"
#include "production/vectors/vector_still.h"

namespace poinsot {

struct StillRequest {
    std::string output{};            // empty: output/<scene>.png
    std::optional<double> time_s{};  // of the motion; empty: see `when`
    PrintChoices print{};
    int bit_depth = 8;  // of a component
    VectorChoices vectors{};
    StillTime when = StillTime::of_scene;
    // The picture is this frame of the film, with the film's histories and places of names; time_s
    // must be empty.
    std::optional<std::int64_t> frame{};
    // Names fade as in the film, for a picture beside which the film is seen.
    bool names_fade = false;
    std::vector<std::optional<Camera>> views{};  // as in StageOptions
};

// A picture in memory, and what its PNG file says besides.
struct PixelStill {
    Image image;
    PngOptions png;     // with its record
    std::string bound;  // how exact the picture is, as in_words says it
};

// A still that is ready to be drawn, once or several times. Movable; the functions below leave it
// as it is.
struct PreparedStill {
    std::unique_ptr<const Session> session;  // to which the picture refers
    StillRequest request;
    FilmTime moment;
    PreparedPicture picture;
};

// Prepares a still, which takes most of the time of a small one; any thread may do it. Throws
// InputError.
PreparedStill prepare_still(Session&& session, StillRequest request);

std::int64_t n_pixels(const PreparedStill& still);
// Whether drawing opens the renderer's context.
bool opens_context(const PreparedStill& still);

// The record, except for the renderer and the instant.
Record record_of(const PreparedStill& still);
// The record of a vector figure, except for its page.
Record vector_record_of(const PreparedStill& still);

// Draws and writes the still; the writer may finish later. Throws InputError, EnvironmentError, and
// the writer's error for an earlier picture.
void draw_still(const PreparedStill& still, LazyRenderer& renderer, StillWriter& writer,
                const Task& task);

// Reports notes and names without space; draw_still does so, too.
void tell_notes(const PreparedStill& still, const Task& task);
// The contents of a journal's figure, as --journal prints them; empty without a journal.
std::string journal_report(const PreparedStill& still);

// Draws the still in memory. Throws InputError for a picture that is drawn in bands or has 16 bits
// per component.
PixelStill still_in_memory(const PreparedStill& still, LazyRenderer& renderer);
// The bytes of a vector figure, whose output's name ends in .pdf or .svg.
VectorStill vectors_of(const PreparedStill& still, LazyRenderer& renderer);

// For a sheet of several stills. The drawing refers to the still; draw_into returns the record, and
// throws as draw_still does.
Drawing drawing_of(const PreparedStill& still);
Record draw_into(const PreparedStill& still, LazyRenderer& renderer, Image& image);

}  // namespace poinsot
