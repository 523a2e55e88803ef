// Any bytes as a scene file: the scene must read back equal after writing, or be refused with a
// place.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scene/files/load_scene.h"
#include "scene/scene_error.h"
#include "scene/write_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const poinsot::Scene scene = poinsot::parse_scene(text, "fuzz.toml");
        const std::string written = poinsot::to_toml(scene);
        if (poinsot::to_toml(poinsot::parse_scene(written, "fuzz.toml")) != written) std::abort();
    } catch (const poinsot::SceneError&) {
        // A bad scene is refused with a message.
    }
    return 0;
}
