// What poinsot throws. Every layer may include this; nothing else is shared by all of them.
#pragma once

#include <stdexcept>
#include <string>

namespace poinsot {

// Base of every failure that a person should read: one line saying what, where and what to do.
class Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// A bad command line, scene or other input (exit code 2).
class InputError : public Error {
 public:
    using Error::Error;
};

// Something that the machine would not do: no context, disk full, encoder (exit code 3).
class EnvironmentError : public Error {
 public:
    using Error::Error;
};

// Whoever read what is printed on stdout reads no more: the program ends without a word.
class ReaderGone : public Error {
 public:
    using Error::Error;
};

}  // namespace poinsot
