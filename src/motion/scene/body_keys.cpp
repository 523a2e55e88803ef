// Keys of the body: its inertia and appearance.
#include "scene/body_faces.h"
#include "scene/scene_key_rows.h"

namespace poinsot {

namespace {

template <BodySpec::Given given>
bool is_given_as(const Scene& scene) {
    return scene.body.given == given;
}

std::string moments_text(const Scene& scene, std::size_t) {
    return toml_text(scene.body.inertia.moments_kg_m2());
}

bool says_its_mass(const Scene& scene) {
    const BodySpec& body = scene.body;
    return body.given == BodySpec::Given::solid || body.given == BodySpec::Given::object ||
           (body.given == BodySpec::Given::mesh && !body.density_kg_m3);
}

template <typename Value>
constexpr auto body(Value BodySpec::*member) {
    return in(&Scene::body, member);
}
constexpr auto object(std::string ObjectSpec::*member) { return in(&Scene::object, member); }
constexpr auto picture(std::string FacePictureSpec::*member) {
    return in(&Scene::object, &ObjectSpec::pictures, member);
}
// Writes points as they were given, before they were moved to the centre of mass.
template <typename Value>
auto as_given(Value PointMass::*member) {
    return key_rows::from(in(&Scene::body, &BodySpec::masses_as_given, member));
}

}  // namespace

std::span<const SceneKey> body_keys() {
    using namespace key_rows;
    using Given = BodySpec::Given;
    static const SceneKey rows[] = {
        // The body, in exactly one of six ways.
        numbers("body.moments_kg_m2", &SceneDraft::moments_kg_m2, positive, "kg m²",
                "[3.0, 2.0, 1.0]",
                "principal moments of inertia, in any order; e1, e2 and e3 keep this order")
            .without_default()
            .written_by(moments_text)
            .written_if(is_given_as<Given::moments>),
        numbers("body.tensor_kg_m2", &SceneDraft::tensor_kg_m2, no_bounds, "kg m²",
                "[[3.0, 0.1, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.5]]",
                "symmetric inertia tensor about the centre of mass, in any body axes")
            .without_default()
            .written_by(from(body(&BodySpec::tensor_kg_m2)))
            .written_if(is_given_as<Given::tensor>),
        text("body.shape", body(&BodySpec::shape), R"("box")",
             "uniform solid: box, ellipsoid, cylinder, …")
            .from_list("solids")
            .written_if(is_given_as<Given::solid>),
        numbers("body.size_m", &SceneDraft::size_m, positive, "m", "[0.3, 0.2, 0.1]",
                "dimensions of the solid: edges of a box, half-axes of an ellipsoid, radius and "
                "height of a cylinder, …")
            .without_default()
            .written_by(from(body(&BodySpec::size_m)))
            .written_if(is_given_as<Given::solid>),
        number("body.mass_kg", &SceneDraft::mass_kg, positive, "kg", "2.0",
               "mass of the solid, object or mesh; without it, the mass of an object follows from "
               "its materials")
            .without_default()
            .written_by(from(body(&BodySpec::mass_kg)))
            .written_if(says_its_mass),
        text("body.object", body(&BodySpec::object), R"("t-handle")",
             "real body, such as a tennis racket")
            .from_list("objects"),
        text("body.mesh", body(&BodySpec::mesh), R"("wedge.obj")",
             "file (.obj or .stl) in the scene's folder with the closed surface of a uniform "
             "solid; poinsot computes the centre of mass"),
        number("body.scale", body(&BodySpec::scale), within(1e-12, 1e12), "m", "0.001",
               "length of one unit of the mesh file; for an object, a factor on its size")
            .omitted_if_default(),
        number("body.density_kg_m3", body(&BodySpec::density_kg_m3), positive, "kg/m³", "2700.0",
               "density of the mesh, instead of mass_kg"),
        boolean("body.allow_unphysical", body(&BodySpec::allow_unphysical), "true",
                "whether to accept moments that no real body has")
            .omitted_if_default(),
        number("body.masses[].mass_kg", in(&SceneDraft::masses, &PointMass::mass_kg), positive,
               "kg", "1.0", "mass of the point")
            .without_default()
            .written_by(as_given(&PointMass::mass_kg)),
        numbers("body.masses[].at_m", in(&SceneDraft::masses, &PointMass::at_m), no_bounds, "m",
                "[0.5, 0.0, -0.25]",
                "position of the point in body axes, measured from any origin; poinsot computes "
                "the centre of mass")
            .without_default()
            .written_by(as_given(&PointMass::at_m)),

        // The appearance of a body given by its moments or its tensor.
        text("object.name", object(&ObjectSpec::name), R"("toutatis")",
             "object whose surface is shown; poinsot matches its principal axes to those of the "
             "body by the order of the moments")
            .from_list("objects"),
        text("object.mesh", object(&ObjectSpec::mesh), R"("wedge.obj")",
             "file (.obj or .stl) in the scene's folder with the surface to show, instead of name"),
        one_of("object.marked_face", object(&ObjectSpec::marked_face), body_faces(), R"("+e3")",
               "flat face to paint in a contrasting colour; +e1 is the face on the +e1 side"),
        one_of("object.pictures[].face", picture(&FacePictureSpec::face), body_faces(), R"("+e3")",
               "flat face that shows the picture, named as in marked_face")
            .without_default(),
        text("object.pictures[].file", picture(&FacePictureSpec::file), R"("cover.png")",
             "PNG picture in the scene's folder, stretched over the face")
            .without_default(),
        one_of("object.pictures[].up", picture(&FacePictureSpec::up), body_faces(), R"("+e1")",
               "direction of the picture's upper edge")
            .default_is("the direction that stretches the picture least"),
    };
    return rows;
}

}  // namespace poinsot
