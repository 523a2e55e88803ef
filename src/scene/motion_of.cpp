#include "scene/motion_of.h"

#include "error/error.h"
#include "scene/scene_error.h"

namespace poinsot {

Motion motion_of(const Scene& scene) {
    try {
        return Motion(problem_of(scene));
    } catch (const InputError& error) {
        const bool given = scene.locations.contains("motion");
        throw SceneError(
            given ? scene.location_of("motion.step_s") : SourceLocation{scene.file.string(), 0, 0},
            error.what());
    }
}

}  // namespace poinsot
