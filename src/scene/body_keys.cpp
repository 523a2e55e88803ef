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
                "[3.0, 2.0, 1.0]", "principal moments, in any order: the axes keep the order given")
            .without_default()
            .written_by(moments_text)
            .written_if(is_given_as<Given::moments>),
        numbers("body.tensor_kg_m2", &SceneDraft::tensor_kg_m2, no_bounds, "kg m²",
                "[[3.0, 0.1, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.5]]",
                "the full symmetric inertia tensor about the centre of mass, in any body axes")
            .without_default()
            .written_by(from(body(&BodySpec::tensor_kg_m2)))
            .written_if(is_given_as<Given::tensor>),
        text("body.shape", body(&BodySpec::shape), R"("box")",
             "a uniform solid: box, ellipsoid, cylinder, …")
            .from_list("solids")
            .written_if(is_given_as<Given::solid>),
        numbers("body.size_m", &SceneDraft::size_m, positive, "m", "[0.3, 0.2, 0.1]",
                "the solid's sizes: a box's edges, an ellipsoid's half-axes, a cylinder's radius "
                "and height, …")
            .without_default()
            .written_by(from(body(&BodySpec::size_m)))
            .written_if(is_given_as<Given::solid>),
        number("body.mass_kg", &SceneDraft::mass_kg, positive, "kg", "2.0",
               "mass of the solid, object or mesh; an object has that of its materials if none is "
               "given")
            .without_default()
            .written_by(from(body(&BodySpec::mass_kg)))
            .written_if(says_its_mass),
        text("body.object", body(&BodySpec::object), R"("t-handle")", "a real thing")
            .from_list("objects"),
        text("body.mesh", body(&BodySpec::mesh), R"("wedge.obj")",
             "a closed surface, .obj or .stl, in the scene's folder: a solid of uniform density in "
             "its axes; the centre of mass is found"),
        number("body.scale", body(&BodySpec::scale), within(1e-12, 1e12), "m", "0.001",
               "one unit of a mesh's lengths, or the factor on an object's")
            .omitted_if_default(),
        number("body.density_kg_m3", body(&BodySpec::density_kg_m3), positive, "kg/m³", "2700.0",
               "density of a mesh, instead of its mass"),
        boolean("body.allow_unphysical", body(&BodySpec::allow_unphysical), "true",
                "keep the mathematics where no real body has these moments")
            .omitted_if_default(),
        number("body.masses[].mass_kg", in(&SceneDraft::masses, &PointMass::mass_kg), positive,
               "kg", "1.0", "mass of one point")
            .without_default()
            .written_by(as_given(&PointMass::mass_kg)),
        numbers("body.masses[].at_m", in(&SceneDraft::masses, &PointMass::at_m), no_bounds, "m",
                "[0.5, 0.0, -0.25]",
                "its place in body axes, from any origin: the centre of mass is found")
            .without_default()
            .written_by(as_given(&PointMass::at_m)),

        // The appearance of a body given by its moments or its tensor.
        text("object.name", object(&ObjectSpec::name), R"("toutatis")",
             "the object panel shows this thing in place of a box; its axes follow the order of "
             "the moments")
            .from_list("objects"),
        text("object.mesh", object(&ObjectSpec::mesh), R"("wedge.obj")",
             "the same from a closed surface in a file, .obj or .stl, in the scene's folder"),
        one_of("object.marked_face", object(&ObjectSpec::marked_face), body_faces(), R"("+e3")",
               "a flat face of the body in a contrasting colour, by the principal axis that leaves "
               "through it"),
        one_of("object.pictures[].face", picture(&FacePictureSpec::face), body_faces(), R"("+e3")",
               "the flat face that has the picture, as in marked_face")
            .without_default(),
        text("object.pictures[].file", picture(&FacePictureSpec::file), R"("cover.png")",
             "the picture, a PNG in the scene's folder; it is stretched over the face")
            .without_default(),
        one_of("object.pictures[].up", picture(&FacePictureSpec::up), body_faces(), R"("+e1")",
               "the direction that its upper side points to")
            .default_is("the one in which it is stretched least"),
    };
    return rows;
}

}  // namespace poinsot
