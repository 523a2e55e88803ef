// [body] object, [body] mesh and [object]: built-in objects and surfaces from files.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "bodies/mass_properties.h"
#include "bodies/mesh_reader.h"
#include "bodies/named_objects.h"
#include "scene/draft_checks.h"

namespace poinsot {

namespace {

// A body of parts with its mass, in the axes that the parts were given in.
struct Thing {
    std::vector<BodySurface> surfaces;
    BodyProperties properties;  // of the parts as given
};

Thing thing_named(std::string_view name) {
    const std::vector<ObjectPart> parts = object_named(name).make();
    Thing thing;
    thing.properties = properties_of(parts);
    for (const ObjectPart& part : parts)
        if (part.use != PartUse::mass_only) thing.surfaces.push_back({part.mesh, part.srgb});
    return thing;
}

// Reads the solid in a file, with unit density; repairs are noted.
Thing thing_in_file(SceneDraft& draft, const std::string& key, const std::string& name) {
    const FileBytes file = file_named(draft, NamedFile::Kind::mesh, key, name);
    SolidMesh solid =
        at_file_key(draft.scene, key, [&] { return read_solid(file.bytes, file.name); });
    for (const std::string& note : solid.notes) {
        draft.scene.notes.push_back(fmt::format("{}: {}: {}", key, name, note));
    }
    Thing thing;
    const DensePart part{mass_properties(solid.mesh), 1.0};
    thing.properties = body_of_parts({&part, 1});
    thing.surfaces.push_back({std::move(solid.mesh), {}});
    return thing;
}

// The surfaces in m, rotated, with the centre of mass at the origin.
std::vector<BodySurface> placed_surfaces(Thing thing, const Eigen::Matrix3d& turn, double scale) {
    for (BodySurface& surface : thing.surfaces) {
        for (Eigen::Vector3d& vertex : surface.mesh.vertices) {
            vertex = turn * (vertex - thing.properties.centre_of_mass_m) * scale;
        }
    }
    return std::move(thing.surfaces);
}

// Inertia of the thing with a given scale and mass, in kg m²: proportional to the square of its
// lengths.
InertiaTensor inertia_of(const Scene& scene, const std::string& key, const Thing& thing) {
    const BodySpec& body = scene.body;
    const double factor = body.mass_kg / thing.properties.mass_kg * body.scale * body.scale;
    return at_scene_key(scene, key, [&] {
        return InertiaTensor::from_matrix(thing.properties.inertia_kg_m2 * factor);
    });
}

// Principal axes in order of their moments, the smallest first, as columns of a proper rotation.
Eigen::Matrix3d axes_by_moment(const InertiaTensor& inertia) {
    std::array<int, 3> order{0, 1, 2};
    const Eigen::Vector3d& I = inertia.moments_kg_m2();
    std::stable_sort(order.begin(), order.end(), [&I](int i, int j) { return I[i] < I[j]; });
    Eigen::Matrix3d axes;
    for (int i = 0; i < 3; ++i) {
        axes.col(i) = inertia.body_from_principal().col(order[static_cast<std::size_t>(i)]);
    }
    if (axes.determinant() < 0.0) axes.col(1) *= -1.0;
    return axes;
}

// The bounding box of a simple solid along the body's axes, in m; none for other bodies.
std::optional<Eigen::Vector3d> extents_of(const BodySpec& body) {
    if (body.given != BodySpec::Given::solid) return std::nullopt;
    const std::vector<double>& size = body.size_m;
    if (body.shape == "box") return Eigen::Vector3d(size[0], size[1], size[2]);
    if (body.shape == "ellipsoid")
        return Eigen::Vector3d(2.0 * size[0], 2.0 * size[1], 2.0 * size[2]);
    if (body.shape == "cylinder") return Eigen::Vector3d(2.0 * size[0], 2.0 * size[0], size[1]);
    return std::nullopt;
}

// Stretches the surfaces along the body's axes so that together they fill a box about the origin:
// the shape of an object on a body with the user's dimensions.
void fit(std::vector<BodySurface>& surfaces, const Eigen::Vector3d& extents_m) {
    Eigen::AlignedBox3d box;
    for (const BodySurface& surface : surfaces)
        for (const Eigen::Vector3d& vertex : surface.mesh.vertices) box.extend(vertex);
    const Eigen::Vector3d stretch = extents_m.cwiseQuotient(box.sizes());
    for (BodySurface& surface : surfaces)
        for (Eigen::Vector3d& vertex : surface.mesh.vertices)
            vertex = stretch.cwiseProduct(vertex - box.center());
}

}  // namespace

FileBytes file_named(const SceneDraft& draft, NamedFile::Kind kind, const std::string& key,
                     const std::string& name) {
    const Scene& scene = draft.scene;
    return at_file_key(scene, key, [&] {
        return draft.files({kind, key, name, scene.location_of(key).line == 0, scene.file});
    });
}

void complete_object_body(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::object;
    Thing thing = at_scene_key(scene, "body.object", [&body] { return thing_named(body.object); });
    body.mass_kg = draft.mass_kg.value_or(thing.properties.mass_kg * std::pow(body.scale, 3));
    body.inertia = inertia_of(scene, "body.object", thing);
    scene.surfaces = placed_surfaces(std::move(thing), Eigen::Matrix3d::Identity(), body.scale);
}

void complete_mesh_body(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::mesh;
    if (draft.has("body.mass_kg") == draft.has("body.density_kg_m3")) {
        refuse(scene, "body.mesh",
               draft.mass_kg ? "body.mass_kg and body.density_kg_m3 both set the mass of a mesh; "
                               "give one of them"
                             : "the mesh has no mass; give body.mass_kg or body.density_kg_m3");
    }
    Thing thing = thing_in_file(draft, "body.mesh", body.mesh);
    // So far its density is 1 kg per cubic unit of the file's lengths.
    const double volume_m3 = thing.properties.mass_kg * std::pow(body.scale, 3);
    body.mass_kg = draft.mass_kg ? *draft.mass_kg : *body.density_kg_m3 * volume_m3;
    body.inertia = inertia_of(scene, "body.mesh", thing);
    body.centre_of_mass_m_body = thing.properties.centre_of_mass_m * body.scale;
    scene.surfaces = placed_surfaces(std::move(thing), Eigen::Matrix3d::Identity(), body.scale);
}

void complete_look(SceneDraft& draft) {
    Scene& scene = draft.scene;
    const bool by_name = draft.has("object.name");
    if (!by_name && !draft.has("object.mesh")) return;
    const std::string key = by_name ? "object.name" : "object.mesh";
    if (by_name && draft.has("object.mesh")) {
        refuse(scene, "object.mesh", "object.mesh contradicts object.name; give one of them");
    }
    const std::optional<Eigen::Vector3d> extents_m = extents_of(scene.body);
    if (scene.body.given != BodySpec::Given::moments &&
        scene.body.given != BodySpec::Given::tensor && !extents_m) {
        refuse(scene, key,
               fmt::format("{} is for a body given by moments, a tensor, a box, an ellipsoid or a "
                           "cylinder; this body has its own shape, so remove it",
                           key));
    }
    Thing thing = by_name ? at_scene_key(scene, key, [&] { return thing_named(scene.object.name); })
                          : thing_in_file(draft, key, scene.object.mesh);

    // Each principal axis is aligned with the body's axis of the same rank of moment.
    const InertiaTensor its_own = at_scene_key(
        scene, key, [&] { return InertiaTensor::from_matrix(thing.properties.inertia_kg_m2); });
    const Eigen::Matrix3d turn =
        axes_by_moment(scene.body.inertia) * axes_by_moment(its_own).transpose();
    scene.surfaces = placed_surfaces(std::move(thing), turn, 1.0);
    if (extents_m) fit(scene.surfaces, *extents_m);
}

}  // namespace poinsot
