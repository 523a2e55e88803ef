// One picture of a scene, from a session to its file.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "production/records/record.h"
#include "production/session/print_size.h"
#include "production/session/progress_sink.h"
#include "production/session/session.h"
#include "production/session/still_moment.h"
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

// A prepared picture. Any thread may construct it.
class StillJob {
 public:
    // Throws InputError.
    StillJob(Session&& session, StillRequest request);
    StillJob(const StillJob&) = delete;
    StillJob& operator=(const StillJob&) = delete;

    std::int64_t n_pixels() const;
    // Whether drawing opens the renderer's context.
    bool opens_context() const {
        return !is_vector_name(request_.output) || has_pixels(request_.vectors);
    }
    // Its record, except for the renderer and the instant.
    Record record() const;

    // Draws and writes the picture; the writer may finish later. Throws InputError,
    // EnvironmentError, and the writer's error for an earlier picture.
    void draw(LazyRenderer& renderer, StillWriter& writer, const ProgressSink& progress);

    // Reports what draw() reports besides the file: notes, and names without space.
    void tell(const ProgressSink& progress) const;
    // What a journal's figure contains, as --journal prints it; empty without a journal. Before the
    // picture is drawn.
    std::string report() const;

    // Draws the picture in memory. Throws InputError for a picture that is drawn in bands or has 16
    // bits per component.
    PixelStill pixels(LazyRenderer& renderer);
    // The bytes of a vector figure, whose output's name ends in .pdf or .svg.
    VectorStill vectors(LazyRenderer& renderer) const;

    // Draws into memory only, for a contact sheet; returns the record. Throws as draw does.
    Record draw_into(LazyRenderer& renderer, Image& image);

    // For a contact sheet of vectors: the drawing, which refers to the job; its record, without the
    // page; the title.
    Drawing drawing() const { return staging_.stage.at(moment_); }
    Record vector_record() const;
    const std::deque<Panel>& panels() const { return staging_.stage.panels(); }
    std::string title() const { return title_of(session_.scene); }

 private:
    void add_moment(Record& record) const;
    // Also sets the density of a file that has a size on paper.
    Record pixel_record(const PictureMaker& pictures, bool is_portable, PngOptions& png) const;
    PixelStill drawn(PictureMaker& pictures, bool is_portable) const;
    VectorStill vectors_of(const Drawing& drawing, LazyRenderer& renderer) const;
    void draw_vectors(OutputPlace place, LazyRenderer& renderer, const ProgressSink& progress);

    Session session_;
    StillRequest request_;
    FilmTime moment_;
    PreparedPicture staging_;
};

}  // namespace poinsot
