// The one thread of a host program on which all pictures are drawn: an OpenGL context belongs to
// the thread that opened it.
#pragma once

#include <poinsot/scene.h>

#include <functional>

#include "production/session/task.h"
#include "production/stills/picture.h"

namespace poinsot::library {

using DrawingWork = std::function<void(LazyRenderer& renderer, const Task& task)>;

// Runs the work on that thread, after the work of other callers, and waits for it. The functions of
// `watch` are called on the calling thread. Throws what the work or a function of `watch` throws;
// EnvironmentError if a forked process cannot draw.
void draw(const ContextChoice& choice, const Watch& watch, const DrawingWork& work);

}  // namespace poinsot::library
