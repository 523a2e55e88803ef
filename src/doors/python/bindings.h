// The parts of the Python module, and what they share.
#pragma once

#include <poinsot/error.h>
#include <poinsot/scene.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "orders/options.h"
#include "system/interrupt.h"

namespace poinsot::python {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style>;

// Tells the library where the package's files are.
void add_files();
// Adds the exceptions, and what turns the library's into them.
void add_errors(py::module_& module);
void add_motion(py::module_& module);
void add_scene(py::module_& module);
void add_fit(py::module_& module);
// Throws InputError unless these are rows of a measured motion: instants (n,) that increase, ω (n,
// 3) and unit quaternions (n, 4), all finite.
void check_rows(const Doubles& times, const std::optional<Doubles>& omega,
                const std::optional<Doubles>& attitude);
void add_comparison(py::module_& module);
void add_options(py::module_& module);
// The options that are neither missing nor None. Throws InputError for a value of another type.
GivenOptions given_options(const py::dict& options);
// A value that cannot be used, in a part of one line: errors.shown().
std::string shown(const py::handle& value);
// A message with the names of keywords in place of the command line's options.
std::string in_keywords(std::string text);

// A contiguous array that owns the values.
template <typename Value>
py::array_t<Value> array_of(std::vector<Value> values, std::vector<py::ssize_t> shape) {
    auto* const kept = new std::vector<Value>(std::move(values));
    const py::capsule owner(kept,
                            [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
    return py::array_t<Value>(std::move(shape), kept->data(), owner);
}

// An option by name; none if it is missing or None. Throws InputError for a value of another type.
template <typename Value>
std::optional<Value> option(const py::dict& options, const char* name) {
    if (!options.contains(name) || options[name].is_none()) return std::nullopt;
    try {
        // Everything has a truth value; only True and False, also NumPy's, are answers.
        py::detail::make_caster<Value> converted;
        if (!converted.load(options[name], !std::is_same_v<Value, bool>)) throw py::cast_error();
        return py::detail::cast_op<Value>(converted);
    } catch (const py::cast_error&) {
        const char* const wanted = std::is_same_v<Value, bool>   ? "True or False"
                                   : std::is_same_v<Value, int>  ? "a whole number"
                                   : std::is_arithmetic_v<Value> ? "a number"
                                                                 : "a text";
        throw InputError(std::string(name) + ": is " + wanted + ", and this is " +
                         shown(options[name]));
    }
}

// Releases the interpreter's lock as long as an object exists. CPython ends a daemon thread that
// waits for the lock while the interpreter shuts down, by unwinding frames that C++ cannot unwind;
// end_calls() therefore waits for such objects, and objects made after it keep the lock.
class WithoutLock {
 public:
    WithoutLock();
    ~WithoutLock();
    WithoutLock(const WithoutLock&) = delete;
    WithoutLock& operator=(const WithoutLock&) = delete;

 private:
    PyThreadState* thread_ = nullptr;
    int generation_ = 0;
};

// At the end of the interpreter: stops drawing and other calls, for good, and waits until no thread
// is without the lock.
void end_calls();
// Whether end_calls() was called.
bool interpreter_ends();
// Throws EnvironmentError then.
void require_interpreter();

// Runs a function of the library without the interpreter's lock. Ctrl-C, and an exception of the
// callbacks, end it: the exception is thrown again here.
class InterruptibleCall {
 public:
    // `say` receives lines, `frames` (n_done, n_frames); both may be None.
    InterruptibleCall(py::object say, py::object frames)
        : say_(std::move(say)), frames_(std::move(frames)) {}

    library::Watch watch();

    template <typename Work>
    void run(const Work& work) {
        require_interpreter();
        try {
            const WithoutLock without_lock;
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

// Runs work that calls stop_if_interrupted(), without the interpreter's lock: Ctrl-C ends it.
template <typename Work>
void run_interruptibly(const Work& work) {
    if (interpreter_ends()) return work();
    InterruptibleCall(py::none(), py::none()).run([&](const library::Watch& watch) {
        const StopsWhen stops(watch.stop);
        work();
    });
}

// Makes T.__new__ raise: pybind11's leaves the C++ object out, and its first use would crash.
// Objects are made by functions of the module only.
py::custom_type_setup without_new();

}  // namespace poinsot::python
