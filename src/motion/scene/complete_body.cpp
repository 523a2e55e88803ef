// [body]: the inertia, whichever way it was given.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "scene/draft_checks.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

const std::array<std::vector<std::string>, 6> ways_of_body{{
    {"body.moments_kg_m2"},
    {"body.tensor_kg_m2"},
    {"body.shape", "body.size_m"},
    {"body.masses"},
    {"body.object"},
    {"body.mesh"},
}};

// A key that only some of the ways accept, and these ways.
struct SharedKey {
    std::string key;
    std::vector<std::string> ways;
    std::string_view belongs_to;
};

void check_shared_keys(const SceneDraft& draft) {
    static const std::array<SharedKey, 3> shared{{
        {"body.mass_kg",
         {"body.shape", "body.size_m", "body.object", "body.mesh"},
         "a shape, an object or a mesh"},
        {"body.scale", {"body.object", "body.mesh"}, "an object or a mesh"},
        {"body.density_kg_m3", {"body.mesh"}, "a mesh"},
    }};
    for (const SharedKey& row : shared) {
        if (!draft.has(row.key)) continue;
        const bool owned = std::any_of(row.ways.begin(), row.ways.end(),
                                       [&draft](const auto& way) { return draft.has(way); });
        if (owned) continue;
        refuse(draft.scene, row.key,
               fmt::format("{} belongs to {}, but the body is given in another way; remove it",
                           row.key, row.belongs_to));
    }
}

void complete_solid(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::solid;
    if (!draft.has("body.shape")) {
        refuse(scene, "body.size_m",
               "body.size_m is given but body.shape is not; name the solid, as in shape = \"box\"");
    }

    const auto table = solids();
    const Solid* solid = find_row(table, body.shape);
    if (solid == nullptr)
        refuse(scene, "body.shape", unknown("shape", body.shape, names_of(table)));
    if (!draft.size_m) {
        refuse(scene, "body.shape",
               fmt::format("body.size_m is missing; give the {}'s {} in m", body.shape,
                           solid->size_meaning));
    }
    if (!draft.mass_kg) {
        refuse(scene, "body.shape", "body.mass_kg is missing; give the solid's mass in kg");
    }
    if (draft.size_m->size() != static_cast<std::size_t>(solid->n_sizes)) {
        refuse(scene, "body.size_m",
               fmt::format("body.size_m has {} {}; a {} has {}: {}", draft.size_m->size(),
                           draft.size_m->size() == 1 ? "entry" : "entries", body.shape,
                           solid->n_sizes, solid->size_meaning));
    }
    body.size_m = *draft.size_m;
    body.mass_kg = *draft.mass_kg;
    body.inertia = at_scene_key(scene, "body.size_m", [&body] {
        return inertia_of_solid(body.shape, body.size_m, body.mass_kg);
    });
}

void complete_masses(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    body.given = BodySpec::Given::masses;
    for (std::size_t i = 0; i < draft.masses.size(); ++i) {
        for (const std::string_view leaf : {"mass_kg", "at_m"}) {
            const std::string item = fmt::format("body.masses[{}]", i);
            const std::string key = fmt::format("{}.{}", item, leaf);
            if (!draft.has(key)) {
                refuse(scene, item,
                       fmt::format("{} is missing; each mass has mass_kg and at_m", key));
            }
        }
    }
    body.masses_as_given = draft.masses;
    const MassDistribution found = at_scene_key(
        scene, "body.masses", [&body] { return inertia_of_masses(body.masses_as_given); });
    body.inertia = found.inertia;
    body.mass_kg = found.mass_kg;
    body.centre_of_mass_m_body = found.centre_of_mass_m_body;
    body.masses = body.masses_as_given;
    for (PointMass& mass : body.masses) mass.at_m -= body.centre_of_mass_m_body;
}

}  // namespace

void complete_body(SceneDraft& draft) {
    Scene& scene = draft.scene;
    BodySpec& body = scene.body;
    refuse_mixed(scene, ways_of_body, "give the body in one way only");
    check_shared_keys(draft);
    const Physicality physicality =
        body.allow_unphysical ? Physicality::waived : Physicality::required;
    if (draft.moments_kg_m2) {
        body.given = BodySpec::Given::moments;
        body.inertia = at_scene_key(scene, "body.moments_kg_m2", [&] {
            return InertiaTensor::from_principal_moments(*draft.moments_kg_m2, physicality);
        });
    } else if (draft.tensor_kg_m2) {
        body.given = BodySpec::Given::tensor;
        body.inertia = at_scene_key(scene, "body.tensor_kg_m2", [&] {
            return InertiaTensor::from_matrix(*draft.tensor_kg_m2, physicality);
        });
        // Halving rounds the smallest doubles, so equal elements are kept unchanged.
        const Eigen::Matrix3d& tensor = *draft.tensor_kg_m2;
        body.tensor_kg_m2 = tensor.binaryExpr(
            tensor.transpose(), [](double x, double y) { return x == y ? x : 0.5 * x + 0.5 * y; });
    } else if (draft.has("body.masses")) {
        complete_masses(draft);
    } else if (draft.has("body.object")) {
        complete_object_body(draft);
    } else if (draft.has("body.mesh")) {
        complete_mesh_body(draft);
    } else if (draft.has("body.shape") || draft.size_m) {
        complete_solid(draft);
    } else {
        refuse(scene, "body",
               "the body is missing; under [body] give moments_kg_m2, tensor_kg_m2, shape with "
               "size_m and mass_kg, object, mesh, or [[body.masses]]");
    }
    complete_look(draft);
    complete_faces(draft);
    if (!body.inertia.note().empty()) {
        scene.notes.push_back(fmt::format("body.tensor_kg_m2: {}", body.inertia.note()));
    }
}

}  // namespace poinsot
