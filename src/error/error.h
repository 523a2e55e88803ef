// The exceptions that poinsot throws. Every layer may include this header; it is the only one that
// all layers share.
#pragma once

#include <stdexcept>
#include <string>

namespace poinsot {

// Base of every failure that a user should read: one line that says what failed, where, and what to
// do.
class Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// A bad command line, scene or other input (exit code 2).
class InputError : public Error {
 public:
    using Error::Error;
};

// The system refused a request: no OpenGL context, disk full, encoder failure (exit code 3).
class EnvironmentError : public Error {
 public:
    using Error::Error;
};

// The reader of stdout closed the pipe (as `| head` does): the program ends without a message.
class ReaderGone : public Error {
 public:
    using Error::Error;
};

}  // namespace poinsot
