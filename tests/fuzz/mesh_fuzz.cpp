// Any bytes as OBJ and as STL, through the check of the solid to its mass properties and shading:
// the result must be a valid mesh or an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "bodies/mass_properties.h"
#include "bodies/mesh_reader.h"
#include "bodies/solid_check.h"
#include "error/error.h"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

using Reader = poinsot::TriangleMesh (*)(std::string_view, std::string_view);

void try_reader(Reader read, std::string_view bytes) {
    try {
        const poinsot::TriangleMesh mesh = read(bytes, "fuzz");
        for (const auto& t : mesh.triangles) {
            for (const std::uint32_t v : t) require(v < mesh.vertices.size());
        }
        for (const auto& v : mesh.vertices) require(v.allFinite());
        for (const auto& n : poinsot::shaded_corners(mesh).normals) require(n.allFinite());
        const poinsot::SolidMesh solid = poinsot::checked_solid(mesh, "fuzz");
        const poinsot::MassProperties properties = poinsot::mass_properties(solid.mesh);
        require(properties.volume_m3 > 0.0);
        require(properties.inertia_unit_density.allFinite());
    } catch (const poinsot::InputError& e) {
        require(std::string_view(e.what()).find('\n') == std::string_view::npos);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try_reader(poinsot::read_obj, bytes);
    try_reader(poinsot::read_stl, bytes);
    return 0;
}
