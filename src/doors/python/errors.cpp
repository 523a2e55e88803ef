#include <poinsot/error.h>

#include "python/bindings.h"

namespace poinsot::python {

namespace {

// Sets the interpreter's exception to one of poinsot.errors with these arguments.
template <typename... Arguments>
void raise(const char* name, const Arguments&... arguments) {
    const py::object type = py::module_::import("poinsot.errors").attr(name);
    const py::object error = type(arguments...);
    PyErr_SetObject(type.ptr(), error.ptr());
}

// With the place of the mistake: file, line and column; the numbers are None for an option.
void raise_input_error(const InputError& error) {
    const std::string message = in_keywords(error.what());
    if (!error.place()) return raise("InputError", message);
    const InputPlace& place = *error.place();
    const auto number = [](int value) {
        return value > 0 ? py::object(py::int_(value)) : py::object(py::none());
    };
    raise("InputError", message, in_keywords(place.file), number(place.line), number(place.column));
}

}  // namespace

std::string shown(const py::handle& value) {
    return py::module_::import("poinsot.errors").attr("shown")(value).cast<std::string>();
}

void add_errors(py::module_&) {
    // The type that pybind11 takes. NOLINTNEXTLINE(performance-unnecessary-value-param)
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const InputError& error) {
            raise_input_error(error);
        } catch (const EnvironmentError& error) {
            raise("EnvironmentError", in_keywords(error.what()));
        }
    });
}

}  // namespace poinsot::python
