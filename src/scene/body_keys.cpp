// Keys of the body: its inertia and appearance.
#include "scene/body_faces.h"
#include "scene/given_value.h"
#include "scene/scene_draft.h"
#include "scene/scene_key_rows.h"
#include "scene/toml_text.h"

namespace poinsot {

namespace {

using std::size_t;

using Given = BodySpec::Given;

FacePictureSpec& picture(const GivenValue& given, SceneDraft& draft) {
    return draft.scene.object.pictures.at(given.item());
}

const SceneKey body_rows[] = {
    // The body, in exactly one of six ways.
    {"body.moments_kg_m2", "three positive numbers", "kg m²", "[3.0, 2.0, 1.0]",
     "principal moments, in any order: the axes keep the order given",
     [](const GivenValue& g, SceneDraft& d) { d.moments_kg_m2 = g.positive_vector(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::moments ? toml_text(s.body.inertia.moments_kg_m2()) : "";
     }},
    {"body.tensor_kg_m2", "three rows of three numbers", "kg m²",
     "[[3.0, 0.1, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.5]]",
     "the full symmetric inertia tensor about the centre of mass, in any body axes",
     [](const GivenValue& g, SceneDraft& d) { d.tensor_kg_m2 = g.matrix(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::tensor ? toml_text(s.body.tensor_kg_m2) : "";
     }},
    {"body.shape", "a string", "", R"("box")",
     "a uniform solid: box, ellipsoid, cylinder, …, see `poinsot list solids`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.shape = g.text(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::solid ? toml_text(std::string_view(s.body.shape)) : "";
     }},
    {"body.size_m", "a list of positive numbers", "m", "[0.3, 0.2, 0.1]",
     "the solid's sizes: a box's edges, an ellipsoid's half-axes, a cylinder's radius and height, "
     "…",
     [](const GivenValue& g, SceneDraft& d) { d.size_m = g.positive_numbers(); },
     [](const Scene& s, size_t) {
         return s.body.given == Given::solid ? toml_text(std::span<const double>(s.body.size_m))
                                             : "";
     }},
    {"body.mass_kg", "a positive number", "kg", "2.0",
     "mass of the solid, object or mesh; default for an object: that of its materials",
     [](const GivenValue& g, SceneDraft& d) { d.mass_kg = g.positive(); },
     [](const Scene& s, size_t) {
         const Given given = s.body.given;
         const bool says = given == Given::solid || given == Given::object ||
                           (given == Given::mesh && !s.body.density_kg_m3);
         return says ? toml_text(s.body.mass_kg) : "";
     }},
    {"body.object", "a string", "", R"("t-handle")", "a real thing, see `poinsot list objects`",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.object = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.body.object); }},
    {"body.mesh", "a string", "", R"("wedge.obj")",
     "a closed surface, .obj or .stl, in the scene's folder: a solid of uniform density in its "
     "axes; the centre of mass is found",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.mesh = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.body.mesh); }},
    {"body.scale", "a number from 1e-12 to 1e12", "m", "0.001",
     "one unit of a mesh's lengths, or the factor on an object's; default 1",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.scale = g.number_between(1e-12, 1e12); },
     [](const Scene& s, size_t) { return s.body.scale == 1.0 ? "" : toml_text(s.body.scale); }},
    {"body.density_kg_m3", "a positive number", "kg/m³", "2700.0",
     "density of a mesh, instead of its mass",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.density_kg_m3 = g.positive(); },
     [](const Scene& s, size_t) { return optional_text(s.body.density_kg_m3); }},
    {"body.allow_unphysical", "true or false", "", "true",
     "keep the mathematics where no real body has these moments; default false",
     [](const GivenValue& g, SceneDraft& d) { d.scene.body.allow_unphysical = g.boolean(); },
     [](const Scene& s, size_t) { return s.body.allow_unphysical ? toml_text(true) : ""; }},
    {"body.masses[].mass_kg", "a positive number", "kg", "1.0", "mass of one point",
     [](const GivenValue& g, SceneDraft& d) { d.masses.at(g.item()).mass_kg = g.positive(); },
     [](const Scene& s, size_t i) { return toml_text(s.body.masses_as_given.at(i).mass_kg); }},
    {"body.masses[].at_m", "three numbers", "m", "[0.5, 0.0, -0.25]",
     "its place in body axes, from any origin: the centre of mass is found",
     [](const GivenValue& g, SceneDraft& d) { d.masses.at(g.item()).at_m = g.vector(); },
     [](const Scene& s, size_t i) { return toml_text(s.body.masses_as_given.at(i).at_m); }},

    // The appearance of a body given by its moments or its tensor.
    {"object.name", "a string", "", R"("toutatis")",
     "the object panel shows this thing, see `poinsot list objects`, in place of a box; its axes "
     "follow the order of the moments",
     [](const GivenValue& g, SceneDraft& d) { d.scene.object.name = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.object.name); }},
    {"object.mesh", "a string", "", R"("wedge.obj")",
     "the same from a closed surface in a file, .obj or .stl, in the scene's folder",
     [](const GivenValue& g, SceneDraft& d) { d.scene.object.mesh = g.text(); },
     [](const Scene& s, size_t) { return text_unless_empty(s.object.mesh); }},
    {"object.marked_face", "a string", "", R"("+e3")",
     "a flat face of the body in a contrasting colour, by the principal axis that leaves through "
     "it: +e1, -e1, +e2, …",
     [](const GivenValue& g, SceneDraft& d) {
         d.scene.object.marked_face = g.one_of(body_faces());
     },
     [](const Scene& s, size_t) { return text_unless_empty(s.object.marked_face); }, body_faces()},
    {"object.pictures[].face", "a string", "", R"("+e3")",
     "the flat face that has the picture, as in marked_face",
     [](const GivenValue& g, SceneDraft& d) { picture(g, d).face = g.one_of(body_faces()); },
     [](const Scene& s, size_t i) {
         return toml_text(std::string_view(s.object.pictures.at(i).face));
     },
     body_faces()},
    {"object.pictures[].file", "a string", "", R"("cover.png")",
     "the picture, a PNG in the scene's folder; it is stretched over the face",
     [](const GivenValue& g, SceneDraft& d) { picture(g, d).file = g.text(); },
     [](const Scene& s, size_t i) {
         return toml_text(std::string_view(s.object.pictures.at(i).file));
     }},
    {"object.pictures[].up", "a string", "", R"("+e1")",
     "the direction that its upper side points to; default: the one in which it is stretched "
     "least",
     [](const GivenValue& g, SceneDraft& d) { picture(g, d).up = g.one_of(body_faces()); },
     [](const Scene& s, size_t i) { return text_unless_empty(s.object.pictures.at(i).up); },
     body_faces()},
};

}  // namespace

std::span<const SceneKey> body_keys() { return body_rows; }

}  // namespace poinsot
