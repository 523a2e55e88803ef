// What a call is refused with.
#pragma once

#include <string>

#include "error/error.h"

namespace poinsot {

// The message of the error that the call throws; empty if it throws none.
template <typename Refused = InputError, typename Call>
std::string refusal_message(const Call& call) {
    try {
        call();
    } catch (const Refused& error) {
        return error.what();
    }
    return "";
}

}  // namespace poinsot
