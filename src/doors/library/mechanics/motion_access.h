// The motion inside a library::Motion, for the other parts of the library.
#pragma once

#include "library/poinsot/motion.h"
#include "mechanics/motion.h"

namespace poinsot::library {

struct Motion::Impl {
    poinsot::Motion motion;
};

struct MotionAccess {
    static Motion of(poinsot::Motion motion);
    static const poinsot::Motion& in(const Motion& motion) { return motion.impl_->motion; }
};

}  // namespace poinsot::library
