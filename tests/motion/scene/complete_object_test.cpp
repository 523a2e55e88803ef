// Bodies given by an object or a mesh, and messages about invalid ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bodies/mass_properties.h"
#include "bodies/named_objects.h"
#include "mesh_folder.h"
#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot {

namespace {

const std::string wedge = "[body]\nmesh = \"wedge.obj\"\n";

// Mass properties of the drawn surfaces, at unit density.
MassProperties drawn(const Scene& scene) { return mass_properties(scene.surfaces.at(0).mesh); }

TEST(ObjectScene, MeshHasTheInertiaOfItsPrism) {
    const MeshFolder folder;
    const Scene scene = scene_of(wedge + "density_kg_m3 = 7200\nscale = 0.1\n" + a_start);
    // m = ϱ·a³/2; about the centroid ∫x² dm = m a²/18, ∫xy dm = −m a²/36, ∫z² dm = m a²/12.
    EXPECT_NEAR(scene.body.mass_kg, 3.6, 4e-15);
    Eigen::Matrix3d expected;
    expected << 5.0, 1.0, 0.0, 1.0, 5.0, 0.0, 0.0, 0.0, 4.0;
    EXPECT_LT((scene.body.inertia.matrix_body() - 1e-3 * expected).norm(),
              1e-17);  // measured 2e-18
    EXPECT_LT((scene.body.centre_of_mass_m_body - Eigen::Vector3d(1, 1, 1.5) / 30.0).norm(), 1e-17);
    EXPECT_FALSE(scene.body.inertia.body_axes_are_principal());
}

TEST(ObjectScene, DrawnSurfacesAreInMetresFromTheCentreOfMass) {
    const MeshFolder folder;
    const Scene scene = scene_of(wedge + "mass_kg = 2\nscale = 0.5\n" + a_start);
    EXPECT_LT(drawn(scene).centre_of_mass_m.norm(), 1e-16);
    EXPECT_NEAR(drawn(scene).volume_m3, 0.5 * 0.125, 1e-16);
    EXPECT_EQ(scene.body.mass_kg, 2.0);
}

TEST(ObjectScene, ObjectsScaleWithTheirLengthsAndMass) {
    const Scene once = scene_of("[body]\nobject = \"book\"\n" + a_start);
    const Scene twice = scene_of("[body]\nobject = \"book\"\nscale = 2\n" + a_start);
    const Scene heavy = scene_of("[body]\nobject = \"book\"\nmass_kg = 3\n" + a_start);
    EXPECT_EQ(twice.body.mass_kg, 8.0 * once.body.mass_kg);
    // At constant density inertia grows with the fifth power of length; products of powers of two
    // are exact.
    EXPECT_EQ(twice.body.inertia.moments_kg_m2(), 32.0 * once.body.inertia.moments_kg_m2());
    EXPECT_LT((heavy.body.inertia.moments_kg_m2() / 3.0 -
               once.body.inertia.moments_kg_m2() / once.body.mass_kg)
                  .norm(),
              1e-17);
}

TEST(ObjectScene, EveryObjectIsReadBack) {
    for (const NamedObject& object : named_objects()) {
        const Scene scene =
            scene_of("[body]\nobject = \"" + std::string(object.name) + "\"\n" + a_start);
        // Parts that only have mass are not shown.
        const auto parts = object.make();
        const auto n_hidden = std::count_if(parts.begin(), parts.end(), [](const ObjectPart& part) {
            return part.use == PartUse::mass_only;
        });
        EXPECT_EQ(scene.surfaces.size() + static_cast<std::size_t>(n_hidden), parts.size())
            << object.name;
        const Scene again = scene_of(to_toml(scene));
        EXPECT_EQ(again.body.inertia.moments_kg_m2(), scene.body.inertia.moments_kg_m2())
            << object.name;
    }
}

TEST(ObjectScene, AppearanceFollowsTheOrderOfTheMoments) {
    // The racket's own axes: largest moment about x, smallest about z. This body has the reverse
    // order.
    const Scene scene = scene_of("[body]\nmoments_kg_m2 = [1.0, 2.0, 2.5]\n" + a_start +
                                 "[object]\nname = \"racket\"\n");
    Eigen::Vector3d reach = Eigen::Vector3d::Zero();
    for (const BodySurface& surface : scene.surfaces) {
        for (const Eigen::Vector3d& v : surface.mesh.vertices) reach = reach.cwiseMax(v.cwiseAbs());
    }
    EXPECT_GT(reach.x(), reach.y());  // the handle lies along the axis of the smallest moment
    EXPECT_GT(reach.y(), reach.z());  // and the face is perpendicular to that of the largest
    EXPECT_EQ(scene.body.inertia.moments_kg_m2(), Eigen::Vector3d(1.0, 2.0, 2.5));
}

TEST(ObjectScene, FilesOutsideTheFolderNeedPermission) {
    const MeshFolder folder;
    folder.write("outside.obj", wedge_obj);
    std::filesystem::create_symlink(folder.path() / "outside.obj",
                                    folder.path() / "scenes" / "link.obj");
    const std::string absolute = (folder.path() / "outside.obj").string();
    for (const std::string& name : {std::string("../outside.obj"), std::string("link.obj"),
                                    std::string("../scenes/../outside.obj"), absolute}) {
        const std::string text = "[body]\nmesh = \"" + name + "\"\nmass_kg = 1\n" + a_start;
        EXPECT_EQ(refusal(text), "scenes/a.toml:2:1: body.mesh = \"" + name +
                                     "\" does not lie in the scene's folder; move it there, or "
                                     "give --allow-outside if you trust the scene");
        const Scene scene =
            parse_scene(text, "scenes/a.toml", {}, files_of_folder(OutsideFiles::allowed));
        EXPECT_EQ(scene.body.mass_kg, 1.0) << name;
    }
    // A path that leaves the folder and returns to it is allowed.
    EXPECT_NO_THROW(scene_of("[body]\nmesh = \"../scenes/wedge.obj\"\nmass_kg = 1\n" + a_start));
}

TEST(ObjectScene, BadMeshesAreRefusedAtTheirKey) {
    const MeshFolder folder;
    const std::string at = "scenes/a.toml:2:1: scenes/";
    const auto said = [](const std::string& name) {
        return refusal("[body]\nmesh = \"" + name + "\"\nmass_kg = 1\n" + a_start);
    };
    EXPECT_EQ(said("missing.obj"), at + "missing.obj: no such file; name an .obj or .stl file");
    folder.write("scenes/open.obj", wedge_obj.substr(0, wedge_obj.size() - 10));
    EXPECT_EQ(said("open.obj").rfind(at + "open.obj", 0), 0u) << said("open.obj");
    EXPECT_NE(said("open.obj").find("its inertia is meaningless"), std::string::npos)
        << said("open.obj");
    folder.write("scenes/bad.obj", "v 0 0\n");
    EXPECT_EQ(said("bad.obj").rfind(at + "bad.obj:1:", 0), 0u) << said("bad.obj");
    folder.write("scenes/empty.stl", "");
    EXPECT_EQ(said("empty.stl"),
              at + "empty.stl: the file is empty; export the surface of a solid");
}

TEST(ObjectScene, ContradictionsAreNamed) {
    const MeshFolder folder;
    EXPECT_EQ(refusal(wedge + a_start),
              "scenes/a.toml:2:1: the mesh has no mass; give body.mass_kg or body.density_kg_m3");
    EXPECT_EQ(refusal(wedge + "mass_kg = 1\ndensity_kg_m3 = 1\n" + a_start),
              "scenes/a.toml:2:1: body.mass_kg and body.density_kg_m3 both set the mass of a mesh; "
              "give one of them");
    EXPECT_EQ(refusal("[body]\nobject = \"book\"\nmesh = \"wedge.obj\"\n" + a_start),
              "scenes/a.toml:3:1: body.mesh contradicts body.object (at line 2); give the body in "
              "one way only");
    EXPECT_EQ(refusal("[body]\nobject = \"bok\"\n" + a_start)
                  .rfind("scenes/a.toml:2:1: unknown object \"bok\"; did you mean \"book\"?", 0),
              0u);
    EXPECT_EQ(refusal(a_body + "scale = 2\n" + a_start),
              "scenes/a.toml:3:1: body.scale belongs to an object or a mesh, but the body is given "
              "in another way; remove it");
    EXPECT_EQ(refusal(a_body + "mass_kg = 2\n" + a_start),
              "scenes/a.toml:3:1: body.mass_kg belongs to a shape, an object or a mesh, but the "
              "body is given in another way; remove it");
    EXPECT_EQ(refusal("[body]\nobject = \"book\"\n" + a_start + "[object]\nname = \"coin\"\n"),
              "scenes/a.toml:7:1: object.name is for a body given by moments, a tensor, a box, an "
              "ellipsoid or a cylinder; this body has its own shape, so remove it");
    EXPECT_EQ(refusal(a_scene + "[object]\nname = \"coin\"\nmesh = \"wedge.obj\"\n"),
              "scenes/a.toml:8:1: object.mesh contradicts object.name; give one of them");
}

// A book with the user's dimensions: the inertia is the box's, the shape the object's, stretched to
// the box.
TEST(ObjectScene, AnObjectsShapeFitsTheBox) {
    const Scene scene = scene_of(
        "[body]\nshape = \"box\"\nsize_m = [\"24 cm\", \"17 cm\", \"3 cm\"]\nmass_kg = \"800 "
        "g\"\n" +
        a_start + "[object]\nname = \"book\"\n");
    const Eigen::Vector3d size(0.24, 0.17, 0.03);
    const double third = 0.8 / 12.0;
    EXPECT_NEAR(scene.body.inertia.moments_kg_m2()[2], third * (0.24 * 0.24 + 0.17 * 0.17), 1e-17);
    ASSERT_GT(scene.surfaces.size(), 1u);
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
    Eigen::Vector3d high = -low;
    for (const BodySurface& surface : scene.surfaces)
        for (const Eigen::Vector3d& vertex : surface.mesh.vertices) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
    EXPECT_LT((high - 0.5 * size).norm(), 1e-15);
    EXPECT_LT((low + 0.5 * size).norm(), 1e-15);
}

}  // namespace

}  // namespace poinsot
