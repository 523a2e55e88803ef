// The exceptions that poinsot throws. A public header: the library installs it as
// <poinsot/error.h>. Every layer may include it. The library exports what is visible by default, so
// that programs that are linked with hidden symbols catch these exceptions, too.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace poinsot {

// Base of every failure that a user should read: one line that says what failed, where, and what to
// do.
class __attribute__((visibility("default"))) Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// Where a bad value was given.
struct InputPlace {
    std::string file;  // or "--set key=value"
    int line = 0;      // from 1; 0: unknown, or the value is not from a file
    int column = 0;    // from 1; 0: unknown
};

// A bad command line, scene or other input (exit code 2).
class __attribute__((visibility("default"))) InputError : public Error {
 public:
    using Error::Error;
    // `message` names the place, too.
    InputError(InputPlace place, const std::string& message)
        : Error(message), place_(std::move(place)) {}

    // The place of the mistake: in a file, or the option that gave the value (line and column 0);
    // none if it is not known.
    const std::optional<InputPlace>& place() const { return place_; }

 private:
    std::optional<InputPlace> place_;
};

// The system refused a request: no OpenGL context, disk full, encoder failure (exit code 3).
class __attribute__((visibility("default"))) EnvironmentError : public Error {
 public:
    using Error::Error;
};

// The reader of stdout closed the pipe (as `| head` does): the program ends without a message.
class __attribute__((visibility("default"))) ReaderGone : public Error {
 public:
    using Error::Error;
};

}  // namespace poinsot
