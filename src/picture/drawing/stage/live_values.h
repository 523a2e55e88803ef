// The numbers that captions may refer to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/drawer.h"
#include "drawing/stage/type/caption_template.h"
#include "scene/scene.h"

namespace poinsot {

// Their values at an instant. Those of a polhode period take longer: they are computed only if this
// text names one of them. Throws InputError if it does and the motion has no such period.
std::vector<LiveValue> live_values(const Scene& scene, const FrameInput& instant,
                                   std::string_view text = {});

// Whether a caption contains numbers that change.
bool changes(const Scene& scene, std::string_view text);

// A caption with these numbers, in the scene's units and language.
std::string live_text(const Scene& scene, std::string_view text, const FrameInput& instant);

}  // namespace poinsot
