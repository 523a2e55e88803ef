// The one error that a label or caption can raise by what it says.
#pragma once

#include <string>

#include "error/error.h"

namespace poinsot {

// A label that does not parse, asks for a character that no font here has, or is larger than a
// label may be. what() reads "label column 8: expected } …".
class LabelError : public InputError {
 public:
    // column: in characters from 1, where the label stops making sense.
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
