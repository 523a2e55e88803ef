// The error for an invalid label or caption.
#pragma once

#include <string>

#include "error/error.h"

namespace poinsot {

// A label that cannot be parsed, needs a character that no font has, or is too long. what() reads
// "label column 8: expected } …".
class LabelError : public InputError {
 public:
    // column: the position of the mistake, in characters counted from 1.
    LabelError(int column, const std::string& reason)
        : InputError("label column " + std::to_string(column) + ": " + reason),
          column_(column),
          reason_(reason) {}

    int column() const { return column_; }
    const std::string& reason() const { return reason_; }

 private:
    int column_;
    std::string reason_;
};

}  // namespace poinsot
