// A film as a page makes it: the frames that `poinsot render` draws, of the film's own size, beside
// the figure that is shown. It makes drawings and the record; it knows neither OpenGL nor the
// browser.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "production/records/record.h"
#include "production/session/picture_setting.h"
#include "system/seal.h"
#include "web/module/live_scene.h"

namespace poinsot {

// What a page makes of a film's frames `first` … `last`.
struct PageOutput {
    enum Kind { film, slide_film, slide_still, picture };

    std::int64_t first = 0, last = 0;
    Kind kind = film;
    std::int64_t frame = 0;     // that a slide's still or a picture shows
    std::string pixels;         // its hash, see Record
    std::string renderer;       // as the browser names it
    std::string maker;          // the browser and its encoder
    std::string packets, file;  // hashes, see Record
};

class PageFilm {
 public:
    // Size, rate and quality are overrides. Throws InputError.
    PageFilm(const PageScene& files, FontSource fonts);
    PageFilm(const PageFilm&) = delete;
    PageFilm& operator=(const PageFilm&) = delete;

    // As JSON: size, rate, number of frames, whether the ground is transparent, and the first
    // frames of the chapters and stops.
    std::string description() const;

    int width_px() const { return session_.scene.film.width_px; }
    int height_px() const { return session_.scene.film.height_px; }

    // Supersampling: the drawing is larger than the frame by this factor.
    int samples() const { return picture_.samples; }
    Drawing drawing_of(std::int64_t frame) const;

    // As JSON: "language", of ISO 639-2; "chapters" of these frames with their first and end
    // frames, counted from `first`; "captions" as WebVTT for a film of this file name, or "".
    std::string texts(std::int64_t first, std::int64_t last, const std::string& file) const;

    // The text of slides.json, without PDFs; it lists these files. Throws SceneError for a scene
    // without stops and chapters.
    std::string slides(std::span<const FileHash> files) const;

    // The record, sealed.
    std::string record(const PageOutput& output);

 private:
    Session session_;
    FilmPlan film_;
    PreparedPicture picture_;
    std::optional<Record> record_;  // what the records of all outputs share
};

// A frame of straight R, G, B and alpha as the planes Y', Cb and Cr of a film, one after the other,
// on white: BT.709, limited range, 4:2:0; or not on white, and alpha follows them. Precondition:
// width and height are even.
std::string planes_of(const Image& frame, bool with_alpha);

}  // namespace poinsot
