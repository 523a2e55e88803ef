// The module poinsot._poinsot: the program's functions for Python. The package in poinsot/ gives
// them the names that people use.
#include <dlfcn.h>

#include <filesystem>

#include "bindings.h"
#include "system/files/program_files.h"

namespace poinsot::python {

library::Watch Running::watch() {
    library::Watch watch;
    if (!say_.is_none())
        watch.say = [this](const std::string& line) {
            const py::gil_scoped_acquire with_lock;
            say_(line);
        };
    if (!frames_.is_none())
        watch.frames = [this](std::int64_t n_done, std::int64_t n_frames) {
            const py::gil_scoped_acquire with_lock;
            frames_(n_done, n_frames);
        };
    watch.stop = [this] {
        const py::gil_scoped_acquire with_lock;
        if (!raised_ && PyErr_CheckSignals() != 0) raised_.emplace();
        return raised_.has_value();
    };
    return watch;
}

namespace {

// The package's folder, in which this module's file lies with the scenes and, in a self-contained
// package, the fonts.
std::filesystem::path folder_of_the_package() {
    Dl_info found{};
    static const char here = 0;
    if (dladdr(&here, &found) == 0 || found.dli_fname == nullptr) return {};
    return std::filesystem::absolute(found.dli_fname).parent_path();
}

}  // namespace

void add_files() { set_program_share(folder_of_the_package()); }

}  // namespace poinsot::python

PYBIND11_MODULE(_poinsot, module) {
    using namespace poinsot::python;
    module.attr("__version__") = POINSOT_VERSION;
    add_files();
    add_errors(module);
    add_motion(module);
    add_scene(module);
    add_comparison(module);
    module.def("stop_drawing", [] {
        const py::gil_scoped_release without_lock;
        poinsot::library::stop_drawing();
    });
}
