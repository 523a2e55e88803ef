// The parts of the Python module, and what they share.
#pragma once

#include <poinsot/scene.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <utility>
#include <vector>

namespace poinsot::python {

namespace py = pybind11;

// Tells the library where the package's files are.
void add_files();
// Adds the exceptions, and what turns the library's into them.
void add_errors(py::module_& module);
void add_motion(py::module_& module);
void add_scene(py::module_& module);
void add_comparison(py::module_& module);

// A contiguous array that owns the values.
template <typename Value>
py::array_t<Value> array_of(std::vector<Value> values, std::vector<py::ssize_t> shape) {
    auto* const kept = new std::vector<Value>(std::move(values));
    const py::capsule owner(kept,
                            [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
    return py::array_t<Value>(std::move(shape), kept->data(), owner);
}

// Runs a function of the library without the interpreter's lock. Ctrl-C, and an exception of the
// callbacks, end it: the exception is thrown again here.
class Running {
 public:
    // `say` receives lines, `frames` (n_done, n_frames); both may be None.
    Running(py::object say, py::object frames) : say_(std::move(say)), frames_(std::move(frames)) {}

    library::Watch watch();

    template <typename Work>
    void run(const Work& work) {
        try {
            const py::gil_scoped_release without_lock;
            work(watch());
        } catch (...) {
            if (raised_) throw *raised_;
            throw;
        }
        if (raised_) throw *raised_;
    }

 private:
    py::object say_, frames_;
    std::optional<py::error_already_set> raised_;
};

}  // namespace poinsot::python
