// What a page calls: the program as functions of a WebAssembly module. web/page/program.js makes
// one instance of it a scene.
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/downsample.h"
#include "image/pixels_xxh64.h"
#include "render/renderer.h"
#include "text/json_text.h"
#include "web/host/kept_fonts.h"
#include "web/host/web_context.h"
#include "web/module/answers.h"
#include "web/module/live_scene.h"
#include "web/module/page_film.h"

namespace poinsot {
namespace {

// All of the instance: a module has no other owner for it.
struct Program {
    std::map<std::string, std::string> files;
    std::unique_ptr<LiveScene> scene;
    std::unique_ptr<PageFilm> film;  // while one is made
    std::int64_t drawn_frame = -1;   // of the film, as pixels
    std::string drawn_pixels;        // its hash
    std::optional<Renderer> renderer;
    std::vector<Camera> held;  // cameras of the panels, while they stay as they are
};
Program& program() {
    static Program it;
    return it;
}

LiveScene& scene() {
    if (!program().scene) throw InputError("no scene is loaded; load one first");
    return *program().scene;
}

Renderer& renderer() {
    if (!program().renderer) program().renderer.emplace(web_context());
    return *program().renderer;
}

PageFilm& film() {
    if (!program().film) throw InputError("no film is open; open one first");
    return *program().film;
}

// A frame of the film, not supersampled any more.
Image frame_of(std::int64_t frame) {
    const Drawing drawing = film().drawing_of(frame);
    const std::string pixels = pixels_of(renderer(), drawing);
    Image image(drawing.width_px, drawing.height_px);
    std::copy(pixels.begin(), pixels.end(), image.bytes().begin());
    return film().samples() == 1 ? image : downsampled(image, film().samples());
}

}  // namespace
}  // namespace poinsot

using namespace poinsot;  // NOLINT(google-build-using-namespace)

// The memory is the module's from here on.
POINSOT_EXPORT(add_font)
void add_font(const char* name, std::uint32_t name_size, const char* bytes, std::uint32_t size) {
    add_kept_font(text_at(name, name_size), text_at(bytes, size));
}

POINSOT_EXPORT(add_file)
void add_file(const char* name, std::uint32_t name_size, const char* bytes, std::uint32_t size) {
    program().files[std::string(text_at(name, name_size))] = text_at(bytes, size);
}

// `overrides`: each followed by a NUL. The answer describes the scene as JSON.
POINSOT_EXPORT(load)
int load(const char* text, std::uint32_t text_size, const char* name, std::uint32_t name_size,
         const char* overrides, std::uint32_t overrides_size, int width_px, int height_px,
         double type_scale) {
    return answered([&] {
        const std::vector<std::string> given = texts_at(overrides, overrides_size);
        // The scene before it stays if this one is refused.
        auto loaded = std::make_unique<LiveScene>(
            PageScene{text_at(text, text_size), std::string(text_at(name, name_size)), given,
                      program().files},
            kept_fonts(), CanvasSize{width_px, height_px, type_scale});
        answer() = loaded->description();
        loaded->hold(program().held);
        program().scene = std::move(loaded);
    });
}

POINSOT_EXPORT(resize) int resize(int width_px, int height_px, double type_scale) {
    return answered([&] {
        scene().resize({width_px, height_px, type_scale});
        answer() = scene().panels_text();
    });
}

// The names of a view's values, in their order.
POINSOT_EXPORT(view_names) int view_names() {
    return answered([&] {
        std::vector<std::string> names;
        for (const ViewField& field : view_fields) names.push_back(json_string(field.name));
        answer() = json_list(names);
    });
}

// n_view_numbers a view: the panel and the values of view_fields; those that are not given are NaN.
POINSOT_EXPORT(set_views) int set_views(const double* numbers, std::uint32_t n_views) {
    return answered([&] {
        std::vector<PanelView> views;
        for (std::uint32_t k = 0; k < n_views; ++k)
            views.push_back(panel_view(std::span(numbers + n_view_numbers * k, n_view_numbers)));
        scene().set_views(std::move(views));
    });
}

// Holds the cameras of this instant, also for scenes that are loaded later, or lets them go.
POINSOT_EXPORT(hold) int hold(double time_s, double film_s, int holds) {
    return answered([&] {
        program().held.clear();
        if (holds != 0) program().held = scene().cameras_at(scene().moment_of(time_s, film_s));
        scene().hold(program().held);
    });
}

// In all of these, `film_s` is the second of the film, or NaN for the first that shows the instant.
// `beside_later_s`: as for LiveScene::drawing_at.
POINSOT_EXPORT(draw) int draw(double time_s, double film_s, double beside_later_s) {
    return answered([&] {
        const Drawing drawing =
            scene().drawing_at(scene().moment_of(time_s, film_s), beside_later_s);
        renderer().render_to(drawing, 0, ScreenAlpha::premultiplied);
    });
}

// The instant of a second of the film, and the first second that shows an instant.
POINSOT_EXPORT(time_at) double time_at(double film_s) { return scene().time_at(film_s); }
POINSOT_EXPORT(film_second_at) double film_second_at(double time_s) {
    return scene().moment_of(time_s).film_s;
}

// Everything that `draw` computes before it calls OpenGL; for measurements.
POINSOT_EXPORT(prepare) int prepare(double time_s) {
    return answered([&] { static_cast<void>(scene().drawing_at(scene().moment_of(time_s))); });
}

// The bytes of a picture, R, G, B and alpha from its top row, lie at the answer.
POINSOT_EXPORT(pixels) int pixels(double time_s, double film_s, int width_px, int height_px) {
    return answered([&] {
        const Drawing drawing =
            scene().drawing_of_size(scene().moment_of(time_s, film_s), width_px, height_px);
        answer() = pixels_of(renderer(), drawing);
    });
}

// A film of a scene, beside the figure: size, rate and quality are among the overrides. The answer
// describes it as JSON.
POINSOT_EXPORT(open_film)
int open_film(const char* text, std::uint32_t text_size, const char* name, std::uint32_t name_size,
              const char* overrides, std::uint32_t overrides_size) {
    return answered([&] {
        const std::vector<std::string> given = texts_at(overrides, overrides_size);
        program().film.reset();
        program().drawn_frame = -1;
        program().film = std::make_unique<PageFilm>(
            PageScene{text_at(text, text_size), std::string(text_at(name, name_size)), given,
                      program().files},
            kept_fonts());
        answer() = program().film->description();
    });
}
POINSOT_EXPORT(close_film) void close_film() { program().film.reset(); }

// The bytes of a frame lie at the answer: its pixels as those of `pixels` (0), its planes on white
// (1), or its planes and alpha (2).
POINSOT_EXPORT(film_frame) int film_frame(double frame, int kind) {
    return answered([&] {
        const Image image = frame_of(static_cast<std::int64_t>(frame));
        if (kind != 0) {
            answer() = planes_of(image, kind == 2);
            return;
        }
        program().drawn_frame = static_cast<std::int64_t>(frame);
        program().drawn_pixels = pixels_xxh64(image);
        answer().assign(image.bytes().begin(), image.bytes().end());
    });
}

// `kind`: a PageOutput::Kind. `texts`: the renderer, the maker and the hashes of the packets and of
// the file, each followed by a NUL. The record of a picture is that of the frame that film_frame
// has drawn as pixels last.
POINSOT_EXPORT(film_record)
int film_record(const char* texts, std::uint32_t texts_size, double first, double last, int kind) {
    return answered([&] {
        const std::vector<std::string> given = texts_at(texts, texts_size);
        answer() = film().record({.first = static_cast<std::int64_t>(first),
                                  .last = static_cast<std::int64_t>(last),
                                  .kind = static_cast<PageOutput::Kind>(kind),
                                  .frame = program().drawn_frame,
                                  .pixels = program().drawn_pixels,
                                  .renderer = given.at(0),
                                  .maker = given.at(1),
                                  .packets = given.at(2),
                                  .file = given.at(3)});
    });
}

POINSOT_EXPORT(film_texts)
int film_texts(const char* file, std::uint32_t file_size, double first, double last) {
    return answered([&] {
        answer() = film().texts(static_cast<std::int64_t>(first), static_cast<std::int64_t>(last),
                                std::string(text_at(file, file_size)));
    });
}

// `hashes`: for each file its name and its SHA-256, each followed by a NUL.
POINSOT_EXPORT(film_slides) int film_slides(const char* hashes, std::uint32_t hashes_size) {
    return answered([&] {
        const std::vector<std::string> given = texts_at(hashes, hashes_size);
        std::vector<FileHash> files;
        for (std::size_t i = 0; i + 1 < given.size(); i += 2)
            files.push_back({given[i], given[i + 1]});
        answer() = film().slides(files);
    });
}

POINSOT_EXPORT(at) int at(double time_s) {
    return answered([&] { numbers() = scene().digits_at(time_s); });
}

POINSOT_EXPORT(state) int state(double time_s, double film_s) {
    return answered([&] { answer() = scene().state_at(scene().moment_of(time_s, film_s)); });
}

POINSOT_EXPORT(svg) int svg(double time_s, double film_s) {
    return answered([&] { answer() = scene().svg_at(scene().moment_of(time_s, film_s)); });
}

POINSOT_EXPORT(grips) int grips(double time_s, double film_s) {
    return answered([&] { answer() = scene().grips_at(scene().moment_of(time_s, film_s)); });
}

POINSOT_EXPORT(omega_at)
int omega_at(double time_s, double film_s, int panel, double x_px, double y_px) {
    return answered([&] {
        numbers().clear();
        if (const auto omega =
                scene().omega_under(scene().moment_of(time_s, film_s), panel, {x_px, y_px}))
            numbers().assign(omega->begin(), omega->end());
    });
}
// thing: 0 the tip of ω, 1 the plane.
POINSOT_EXPORT(start_at)
int start_at(double time_s, double film_s, int panel, int thing, double x_px, double y_px) {
    return answered([&] {
        numbers().clear();
        const FilmTime moment = scene().moment_of(time_s, film_s);
        const Eigen::Vector2d px(x_px, y_px);
        const auto omega = thing == 0 ? scene().omega_under(moment, panel, px)
                                      : scene().omega_of_plane_at(moment, panel, px);
        const auto start = scene().start_with(moment, omega);
        if (!start) return;
        const Eigen::Vector3d& at_start = start->omega_body;
        const Eigen::Quaterniond& q = start->space_from_body;
        numbers() = {at_start.x(), at_start.y(), at_start.z(), q.w(), q.x(), q.y(), q.z()};
    });
}
POINSOT_EXPORT(energy_at)
int energy_at(double time_s, double film_s, int panel, double x_px, double y_px) {
    return answered([&] {
        numbers().clear();
        if (const auto energy_J =
                scene().energy_of_plane_at(scene().moment_of(time_s, film_s), panel, {x_px, y_px}))
            numbers().push_back(*energy_J);
    });
}
// After the context of the canvas was lost, and when the page gives it back.
POINSOT_EXPORT(lose_context) void lose_context() { program().renderer.reset(); }
