// A scene from the texts and files that a page hands over.
#pragma once

#include "web/module/live_scene.h"

namespace poinsot {

// Throws InputError.
Scene scene_of_page(const PageScene& files);

Session session_of_page(const Scene& scene, FontSource fonts);

}  // namespace poinsot
