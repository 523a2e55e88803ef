// Scenes: the motion of a scene as numbers, and its pictures.
//
// Functions throw InputError and EnvironmentError (<poinsot/error.h>) with the sentences of the
// command line. All of them may be called from any thread; one thread of the library draws all
// pictures, one after another.
#pragma once

#include <poinsot/options.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::library {

// Callbacks of long work. They are called on the caller's thread, about every 20 ms; unset ones do
// nothing. If `stop` returns true, drawing, sampling and stepping methods end with an
// EnvironmentError; a film continues at the next call.
struct Watch {
    std::function<void(const std::string& line)> say{};  // notes, and the bound of the errors
    std::function<void(std::int64_t n_done, std::int64_t n_frames)> frames{};
    std::function<bool()> stop{};
    // What a still or a figure for a journal contains, a line each: size, least sizes, contrasts,
    // and what is left out. As `poinsot still --journal` prints it.
    std::function<void(const std::string& lines)> report{};
};

// One picture. The instant is `time_s` of the motion, in seconds; without it film.still_s of the
// scene or, with `clearest` or where the scene has none, the instant of the film at which the
// arrows are farthest apart.
struct StillOptions {
    std::optional<double> time_s{};
    bool clearest = false;
    PaperOptions paper{};
    ContextOptions context{};
};

// A picture in memory. Copies share it.
class __attribute__((visibility("default"))) Still {
 public:
    int width_px() const;
    int height_px() const;
    // width × height × 4 bytes: sRGB-encoded R, G, B and linear, non-premultiplied alpha; row 0 is
    // the top.
    std::span<const std::uint8_t> rgba() const;
    // The bytes of the file that `poinsot still` writes, with its record.
    std::vector<std::uint8_t> png() const;
    // How far its lines may be from the truth, in words.
    const std::string& bound() const;

    // Copies only: a still that was moved from would be empty.
    Still(const Still&) = default;
    Still& operator=(const Still&) = default;
    ~Still() = default;

 private:
    friend struct SceneAccess;
    struct Impl;
    explicit Still(std::shared_ptr<const Impl> contents) : impl_(std::move(contents)) {}
    std::shared_ptr<const Impl> impl_;
};

// A figure of vectors. `format`: svg or pdf; `shading` and `text`: as for `poinsot still`.
struct FigureOptions {
    std::optional<double> time_s{};
    bool clearest = false;
    PaperOptions paper{};
    ContextOptions context{};  // with shading "picture"
    std::string format = "svg", shading = "tone", text = "font";
};

// A film, a PNG sequence (#### in the name), a page (.html) or slides (.pptx).
struct RenderOptions {
    std::optional<std::pair<std::int64_t, std::int64_t>> frames{};  // first and last, from 0
    ContextOptions context{};
};

// Columns of numbers, one row for each instant.
struct Table {
    std::vector<std::string> names;  // with units, as omega_body_1_rad_s
    std::size_t n_rows = 0;
    std::vector<double> values;  // column by column: value j of column i is values[i·n_rows + j]
};

// A scene. Immutable; copies share it.
class __attribute__((visibility("default"))) Scene {
 public:
    // `values`: "key=value", as for --set. `allow_outside`: whether the scene may name files
    // outside its folder.
    static Scene from_file(const std::string& file, const std::vector<std::string>& values = {},
                           bool allow_outside = false);
    // `name` stands in messages for the file; the scene is named after it, and files that the scene
    // names lie in its folder.
    static Scene from_text(const std::string& text, const std::string& name = "scene.toml",
                           const std::vector<std::string>& values = {}, bool allow_outside = false);
    // The same scene with more values.
    Scene with(const std::vector<std::string>& values) const;

    std::string name() const;
    std::string title() const;
    const std::string& text() const;
    std::vector<std::string> values() const;
    // As given to from_file or from_text.
    const std::string& file() const;
    bool allows_outside() const;
    int width_px() const;
    int height_px() const;
    std::string language() const;

    // The object that `poinsot check --json` prints.
    std::string check_json(const Watch& watch = {}) const;

    // The motion at these instants, in seconds, in this order. `columns`: as for --columns; empty:
    // the default ones, without units in their names.
    Table sample(std::span<const double> times_s, const std::vector<std::string>& columns = {},
                 const Watch& watch = {}) const;

    // The errors of somebody else's motion against this one, one row for each instant, in this
    // order. `omega`: three numbers for each instant, rad/s, body axes; `attitude`: four, the unit
    // quaternion (w, x, y, z) of space from body; one of both may be empty. Columns, if they can be
    // computed: attitude_rad, the angle between the attitudes; omega_rad_s, |ω − exact|;
    // omega_share, the same divided by |exact|; and of torque-free motions energy_share,
    // T/exact − 1, momentum_share, |L|/exact − 1, and momentum_tilt_rad, the angle between L in
    // space and the exact L. Throws InputError for other numbers of values, and as sample does.
    Table departure(std::span<const double> times_s, std::span<const double> omega,
                    std::span<const double> attitude, const Watch& watch = {}) const;

    Still still(const StillOptions& options = {}, const Watch& watch = {}) const;
    // The bytes of an SVG or a PDF.
    std::string figure(const FigureOptions& options = {}, const Watch& watch = {}) const;
    // Writes the file that `path` names by its suffix; as `poinsot render`. An interrupted film
    // continues.
    void render(const std::string& path, const RenderOptions& options = {},
                const Watch& watch = {}) const;
    // Writes a film and stills for each stop; as `poinsot render --slides`.
    void slides(const std::string& folder, const ContextOptions& context = {},
                const Watch& watch = {}) const;

    // Copies only: a scene that was moved from would be empty.
    Scene(const Scene&) = default;
    Scene& operator=(const Scene&) = default;
    ~Scene() = default;

 private:
    friend struct SceneAccess;
    struct Impl;
    explicit Scene(std::shared_ptr<const Impl> contents) : impl_(std::move(contents)) {}
    std::shared_ptr<const Impl> impl_;
};

// Ends the thread that draws, and closes its OpenGL context: pictures that are drawn or wait are
// stopped; the next picture begins anew. For hosts that unload libraries in an order of their own.
__attribute__((visibility("default"))) void stop_drawing();

}  // namespace poinsot::library
