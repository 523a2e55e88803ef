// Lets a caller end long stepping.
#pragma once

#include <functional>

namespace poinsot {

// Asked now and then while a motion is stepped: whether to stop. Empty: never.
using StopCheck = std::function<bool()>;

}  // namespace poinsot
