// The numbers that captions may refer to.
#pragma once

#include <vector>

#include "drawing/stage/drawer.h"
#include "drawing/stage/type/caption_template.h"
#include "scene/scene.h"

namespace poinsot {

// Their values at an instant.
std::vector<LiveValue> live_values(const Scene& scene, const FrameInput& instant);

}  // namespace poinsot
