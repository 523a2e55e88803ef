#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "library/production/scene_access.h"
#include "python/bindings.h"

namespace poinsot::python {

namespace {

using library::Scene;
using library::SceneAccess;

// The pixels share the memory of the still.
py::array pixels_of(const library::Still& still) {
    using namespace py::literals;
    auto* const kept = new library::Still(still);
    const py::capsule owner(kept,
                            [](void* pointer) { delete static_cast<library::Still*>(pointer); });
    const std::vector<py::ssize_t> shape{still.height_px(), still.width_px(), 4};
    py::array_t<std::uint8_t> pixels(shape, still.rgba().data(), owner);
    // Its record describes these pixels.
    pixels.attr("setflags")("write"_a = false);
    return pixels;
}

py::bytes png_of(const library::Still& still) {
    std::vector<std::uint8_t> png;
    {
        const WithoutLock without_lock;
        png = still.png();
    }
    return {reinterpret_cast<const char*>(png.data()), png.size()};
}

py::tuple sample(const Scene& scene, const Doubles& times,
                 const std::vector<std::string>& columns) {
    library::Table table;
    const std::span<const double> times_s(times.data(), static_cast<std::size_t>(times.size()));
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        table = scene.sample(times_s, columns, watch);
    });
    const auto n_columns = static_cast<py::ssize_t>(table.names.size());
    const auto n_rows = static_cast<py::ssize_t>(table.n_rows);
    return py::make_tuple(table.names, array_of(std::move(table.values), {n_columns, n_rows}));
}

py::tuple departure(const Scene& scene, const Doubles& times, const std::optional<Doubles>& omega,
                    const std::optional<Doubles>& attitude) {
    check_rows(times, omega, attitude);
    const auto span_of = [](const Doubles& values) {
        return std::span<const double>(values.data(), static_cast<std::size_t>(values.size()));
    };
    const std::span<const double> none;
    library::Table table;
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        table = scene.departure(span_of(times), omega ? span_of(*omega) : none,
                                attitude ? span_of(*attitude) : none, watch);
    });
    const auto n_columns = static_cast<py::ssize_t>(table.names.size());
    const auto n_rows = static_cast<py::ssize_t>(table.n_rows);
    return py::make_tuple(table.names, array_of(std::move(table.values), {n_columns, n_rows}));
}

std::string check_json(const Scene& scene) {
    std::string answer;
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        answer = scene.check_json(watch);
    });
    return answer;
}

// What a picture reports, as plain values: the interpreter's lock is released while it is drawn.
struct Told {
    std::vector<std::string> notes;
    std::optional<std::string> report;

    library::Watch listening(library::Watch watch) {
        watch.say = [this](const std::string& line) { notes.push_back(in_keywords(line)); };
        watch.report = [this](const std::string& lines) { report = in_keywords(lines); };
        return watch;
    }
};

py::tuple still(const Scene& scene, const py::dict& options) {
    const GivenOptions given = given_options(options);
    std::optional<library::Still> made;
    Told told;
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        made = SceneAccess::still(scene, given, told.listening(watch));
    });
    return py::make_tuple(*made, told.notes, told.report);
}

py::tuple figure(const Scene& scene, const std::string& format, const py::dict& options) {
    const GivenOptions given = given_options(options);
    std::string bytes;
    Told told;
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        bytes = SceneAccess::figure(scene, given, format, told.listening(watch));
    });
    return py::make_tuple(py::bytes(bytes), told.notes, told.report);
}

void make(const Scene& scene, const FilmOrder& order, const py::dict& options,
          const py::object& say, const py::object& progress) {
    const GivenOptions given = given_options(options);
    InterruptibleCall(say, progress).run([&](const library::Watch& watch) {
        SceneAccess::film(scene, order, given, watch);
    });
}

void render(const Scene& scene, const std::string& path, const py::dict& options,
            const py::object& say, const py::object& progress) {
    if (path.empty()) throw InputError("the output has no name; give one, as film.mp4");
    make(scene, {.output = path}, options, say, progress);
}

void slides(const Scene& scene, const std::string& folder, const py::dict& options,
            const py::object& say, const py::object& progress) {
    if (folder.empty()) throw InputError("the folder of the slides has no name; give one");
    make(scene, {.slides = folder}, options, say, progress);
}

}  // namespace

void add_scene(py::module_& module) {
    using namespace py::literals;
    py::class_<library::Still>(module, "Still", without_new())
        .def_property_readonly("pixels", pixels_of)
        .def_property_readonly("png", png_of)
        .def_property_readonly("bound", &library::Still::bound);
    const auto without_lock = py::call_guard<WithoutLock>();
    py::class_<Scene>(module, "Scene", without_new())
        .def_static("from_file", &Scene::from_file, without_lock, "file"_a, "values"_a,
                    "allow_outside"_a)
        .def_static("from_text", &Scene::from_text, without_lock, "text"_a, "name"_a, "values"_a,
                    "allow_outside"_a)
        .def("with_values", &Scene::with, without_lock, "values"_a)
        .def_property_readonly("name", &Scene::name)
        .def_property_readonly("title", &Scene::title)
        .def_property_readonly("text", &Scene::text)
        .def_property_readonly("values", &Scene::values)
        .def_property_readonly("file", &Scene::file)
        .def_property_readonly("allow_outside", &Scene::allows_outside)
        .def_property_readonly("width_px", &Scene::width_px)
        .def_property_readonly("height_px", &Scene::height_px)
        .def("check_json", check_json)
        .def("sample", sample, "times_s"_a, "columns"_a)
        .def("departure", departure, "times_s"_a, "omega"_a, "attitude"_a)
        .def("still", still, "options"_a)
        .def("figure", figure, "format"_a, "options"_a)
        .def("render", render, "path"_a, "options"_a, "say"_a, "progress"_a)
        .def("slides", slides, "folder"_a, "options"_a, "say"_a, "progress"_a);
}

}  // namespace poinsot::python
