// CPU time of a video frame, all threads included: with each element omitted in turn, by stage, and
// depending on the number of pixels, panels and points of the curves.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "encoding/yuv.h"
#include "image/png.h"
#include "production/session/session.h"
#include "production/stills/picture.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace {

using namespace poinsot;

const std::string scene_file = POINSOT_SCENES_DIR "/generic.toml";
const std::vector<std::string> elements{"plane",    "ellipsoid", "polhode", "herpolhode",
                                        "momentum", "omega",     "axes",    "contact",
                                        "title",    "caption",   "clock"};

std::string show(const std::string& but) {
    std::string list;
    for (const std::string& element : elements)
        if (element != but) list += (list.empty() ? "\"" : ", \"") + element + '"';
    return "show=[" + list + "]";
}

// A film whose frames are drawn one after the other.
class Film {
 public:
    explicit Film(const std::vector<std::string>& overrides, std::int64_t first = 100)
        : n_drawn_(first),
          session_(
              session_of(load_scene(scene_file, overrides_of(overrides)), {installed_fonts()})),
          plan_(film_plan(session_)),
          pictures_(session_, easel_, {plan_.time_of(0), plan_.last_time_s()}) {
        for (int k = 0; k < 3; ++k) draw();
    }
    void draw() { pictures_.draw(next_moment(), image_); }
    Drawing drawing() { return pictures_.stage().at(next_moment()); }
    const Image& image() const { return image_; }
    PictureCounts counts() { return easel_.renderer().counts(); }

 private:
    FilmTime next_moment() { return plan_.moment_of(n_drawn_++ % plan_.n_frames); }

    std::int64_t n_drawn_;
    Session session_;
    FilmPlan plan_;
    LazyRenderer easel_;
    PictureMaker pictures_;
    Image image_;
};

void draw(benchmark::State& state, const std::vector<std::string>& overrides) {
    Film film(overrides);
    for ([[maybe_unused]] auto _ : state) film.draw();
}

// Draws frames of a film of an hour from this frame on: the herpolhode is that long. segments:
// drawn per frame.
void draw_late(benchmark::State& state, std::int64_t frame) {
    Film film({"film.duration_s=3600"}, frame);
    for ([[maybe_unused]] auto _ : state) film.draw();
    const PictureCounts counts = film.counts();
    state.counters["segments"] = static_cast<double>(counts.n_lasting_segments);
    state.counters["tiles"] = static_cast<double>(counts.n_tiles);
}

void make_drawing(benchmark::State& state) {
    Film film({});
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(film.drawing());
}

void convert(benchmark::State& state) {
    const Film film({});
    const Image& image = film.image();
    const auto n =
        static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height());
    std::vector<std::uint8_t> y(n), cb(n / 4), cr(n / 4);
    YuvConverter converter(image.width());
    for ([[maybe_unused]] auto _ : state)
        converter.convert(image, {y.data(), cb.data(), cr.data(), image.width(), image.width() / 2,
                                  image.width() / 2});
}

void encode_as_png(benchmark::State& state, int level) {
    const Film film({});
    PngOptions options;
    options.deflate_level = level;
    PngEncoder encoder(options);
    std::size_t size = 0;
    for ([[maybe_unused]] auto _ : state) size = encoder.encode(film.image()).size();
    state.counters["kB"] = static_cast<double>(size) / 1e3;
}

template <class... Arguments>
void add(const std::string& name, Arguments&&... arguments) {
    benchmark::RegisterBenchmark(name.c_str(), std::forward<Arguments>(arguments)...)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

std::string panels(int n) {
    std::string list;
    const char* kinds[] = {"space", "body", "plan", "plot"};
    for (int k = 0; k < n; ++k)
        list += std::string(list.empty() ? "" : ", ") + "{kind = \"" + kinds[k] +
                "\", column = " + std::to_string(k % 2) + ", row = " + std::to_string(k / 2) + "}";
    return "panels=[" + list + "]";
}

}  // namespace

int main(int argc, char** argv) {
    add("draw/all", draw, std::vector<std::string>{show("")});
    for (const std::string& element : elements)
        add("draw/without_" + element, draw, std::vector<std::string>{show(element)});
    add("stage/drawing", make_drawing);
    add("stage/to_yuv", convert);
    for (const int level : {1, 2, 4, 6, 9})
        add("stage/png_level_" + std::to_string(level), encode_as_png, level);
    for (const char* size : {"320x180", "640x360", "1280x720", "1920x1080", "3840x2160"})
        add(std::string("pixels/") + size, draw,
            std::vector<std::string>{std::string("film.size=") + size});
    for (const char* accuracy : {"10", "1", "0.1", "0.01"})
        add(std::string("points/accuracy_px_") + accuracy, draw,
            std::vector<std::string>{std::string("accuracy_px=") + accuracy});
    for (const std::int64_t frame : {10, 100, 1000, 10'000, 100'000})
        add("history/frame_" + std::to_string(frame), draw_late, frame);
    for (int n = 1; n <= 4; ++n)
        add("panels/" + std::to_string(n), draw, std::vector<std::string>{panels(n)});
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
