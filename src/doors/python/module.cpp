// The module poinsot._poinsot: the program's functions for Python. The package in poinsot/ gives
// them the names that people use.
#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "python/bindings.h"
#include "system/files/program_files.h"
#include "system/files/standard_streams.h"

namespace poinsot::python {

namespace {

// The lock guards all of these.
int n_without_lock = 0;
int generation = 0;  // of forked processes: the other threads of a parent do not exist in its child
bool has_ended = false;

void forget_other_threads() {
    n_without_lock = 0;
    ++generation;
}

}  // namespace

WithoutLock::WithoutLock() {
    if (has_ended) return;
    ++n_without_lock;
    generation_ = generation;
    thread_ = PyEval_SaveThread();
}

WithoutLock::~WithoutLock() {
    if (thread_ == nullptr) return;
    PyEval_RestoreThread(thread_);
    if (generation_ != generation) return;
    --n_without_lock;
    if (!has_ended) return;
    // All but daemon threads have ended. Python would stop this one anyway, but perhaps in the
    // middle of the report of an exception, which holds stderr's lock (Python 3.14 aborts then).
    PyEval_SaveThread();
    while (true) pause();
}

void end_calls() {
    has_ended = true;
    do {
        const bool waits = n_without_lock > 0;
        {
            const py::gil_scoped_release to_others;
            library::stop_drawing();
            if (waits) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    } while (n_without_lock > 0);
}

py::custom_type_setup without_new() {
    return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
        heap_type->ht_type.tp_new = [](PyTypeObject* type, PyObject*, PyObject*) -> PyObject* {
            PyErr_Format(PyExc_TypeError,
                         "%s: poinsot's functions make such objects; it cannot be called",
                         type->tp_name);
            return nullptr;
        };
    });
}

bool interpreter_ends() { return has_ended; }

void require_interpreter() {
    if (has_ended) throw EnvironmentError("the interpreter is shutting down; draw before its end");
}

library::Watch InterruptibleCall::watch() {
    library::Watch watch;
    if (!say_.is_none())
        watch.say = [this](const std::string& line) {
            const py::gil_scoped_acquire with_lock;
            say_(in_keywords(line));
        };
    if (!frames_.is_none())
        watch.frames = [this](std::int64_t n_done, std::int64_t n_frames) {
            const py::gil_scoped_acquire with_lock;
            frames_(n_done, n_frames);
        };
    watch.stop = [this] {
        const py::gil_scoped_acquire with_lock;
        if (has_ended) return true;
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
    poinsot::occupy_closed_streams();
    module.attr("__version__") = POINSOT_VERSION;
    add_files();
    add_errors(module);
    add_motion(module);
    add_scene(module);
    add_fit(module);
    add_comparison(module);
    add_options(module);
    pthread_atfork(nullptr, nullptr, forget_other_threads);
    // Before the interpreter unloads libraries in an order of its own.
    py::module_::import("atexit").attr("register")(py::cpp_function(end_calls));
}
