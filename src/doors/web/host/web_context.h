// The WebGL context of the page's canvas.
#pragma once

#include <string>

#include "render/context/context_info.h"
#include "render/renderer.h"

namespace poinsot {

// What the browser says of it.
ContextInfo web_context();

// Draws a picture beside the canvas and returns its bytes: R, G, B and alpha, not premultiplied,
// from the top row.
std::string pixels_of(Renderer& renderer, const Drawing& drawing);

}  // namespace poinsot
