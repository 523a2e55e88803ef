// A scene from the texts and files that a page hands over.
#pragma once

#include "web/module/lecture.h"

namespace poinsot {

// Throws InputError.
Scene scene_of_page(const LectureFiles& files);

Session session_of_page(const Scene& scene, FontSource fonts);

}  // namespace poinsot
