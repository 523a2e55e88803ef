// Which meshes are accepted as solids, and which faults are repaired.
#include "bodies/solid_check.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "bodies/mass_properties.h"
#include "bodies/solid_meshes.h"
#include "error/error.h"

namespace poinsot {
namespace {

std::string refusal(const TriangleMesh& mesh) {
    try {
        checked_solid(mesh, "m.obj");
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& by) {
    return placed(mesh, Eigen::Affine3d(Eigen::Translation3d(by)));
}

double volume(const SolidMesh& solid) { return mass_properties(solid.mesh).volume_m3; }

const TriangleMesh cube = box_mesh({2.0, 2.0, 2.0});

TEST(ClosedSurfaces, PassUnchanged) {
    const SolidMesh solid = checked_solid(cube, "m.obj");
    EXPECT_EQ(solid.mesh.vertices, cube.vertices);
    EXPECT_EQ(solid.mesh.triangles, cube.triangles);
    EXPECT_TRUE(solid.notes.empty());
}

// A missing triangle leaves its three edges open; the message gives their number and place.
TEST(OpenSurfaces, AreRejectedWithEdgeCountAndPlace) {
    TriangleMesh open = cube;
    open.triangles.pop_back();
    EXPECT_EQ(edge_faults(open).n_open, 3u);
    const std::string message = refusal(open);
    EXPECT_TRUE(
        message.starts_with("m.obj: the surface is not closed: 3 edges belong to one "
                            "triangle only, the first from (-1, -1, 1) to (1, 1, 1); "))
        << message;
    EXPECT_NE(
        message.find("a mesh that is not closed has no inside, so its inertia is meaningless; "
                     "fill its holes"),
        std::string::npos)
        << message;
}

TEST(CrowdedEdges, AreRejected) {
    // Two cubes that share one vertical edge.
    const std::string message =
        refusal(joined(std::vector<TriangleMesh>{cube, moved(cube, {2.0, 2.0, 0.0})}));
    EXPECT_NE(message.find("1 edge is shared by more than two triangles, the first from (1, 1, "),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("separate the parts"), std::string::npos) << message;
}

TEST(TurnedTriangles, AreRejected) {
    TriangleMesh turned = cube;
    std::swap(turned.triangles[0][1], turned.triangles[0][2]);
    EXPECT_EQ(edge_faults(turned).n_reversed, 3u);
    EXPECT_NE(refusal(turned).find("3 edges run the same way in both their triangles"),
              std::string::npos);
}

std::string notes_of(const std::vector<TriangleMesh>& parts) {
    std::string notes;
    for (const std::string& note : checked_solid(joined(parts), "m.obj").notes)
        notes += note + "\n";
    return notes;
}

// Where surfaces overlap, mass counts twice: the mesh is accepted with a note.
TEST(CrossingSurfaces, AreNoted) {
    for (const Eigen::Vector3d& by :
         {Eigen::Vector3d(1.0, 1.0, 1.0), Eigen::Vector3d(0.3, 0.5, 0.7),
          Eigen::Vector3d(1.9, 0.1, 0.2)}) {
        const std::string notes = notes_of({cube, moved(cube, by)});
        EXPECT_NE(notes.find("m.obj: the surface crosses itself, first near ("), std::string::npos)
            << by.transpose() << ": " << notes;
    }
    // A bar through a cube: no vertex of either is inside the other.
    EXPECT_NE(notes_of({cube, box_mesh({0.5, 0.5, 9.0})}).find("crosses itself"),
              std::string::npos);
    // Solids side by side, touching or apart give no note.
    EXPECT_EQ(notes_of({cube, moved(cube, {3.0, 0.0, 0.0})}), "");
    EXPECT_EQ(notes_of({cube, moved(cube, {2.0, 0.5, 0.25})}), "");
}

TEST(NestedSurfaces, AreNotedUnlessTheyAreCavities) {
    const TriangleMesh small = box_mesh({1.0, 1.0, 1.0}), least = box_mesh({0.5, 0.5, 0.5});
    EXPECT_NE(notes_of({cube, small}).find("m.obj: 1 piece lies within another"),
              std::string::npos);
    TriangleMesh cavity = small;
    for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
    EXPECT_EQ(notes_of({cube, cavity}), "");
    // A solid inside a cavity is a separate solid.
    EXPECT_EQ(notes_of({cube, cavity, least}), "");
    // Its bounding box lies inside the other's, but the solid does not.
    std::vector<TriangleMesh> cross{box_mesh({9.0, 1.0, 1.0}), moved(least, {0.0, 0.0, 0.0})};
    EXPECT_NE(notes_of(cross).find("within another"), std::string::npos);
}

TEST(SplitVertices, AreWelded) {
    TriangleMesh soup;
    for (const auto& t : cube.triangles) {
        const auto n = static_cast<std::uint32_t>(soup.vertices.size());
        for (const std::uint32_t v : t) soup.vertices.push_back(cube.vertices[v]);
        soup.triangles.push_back({n, n + 1, n + 2});
    }
    soup.vertices.emplace_back(1e6, 0.0, 0.0);  // used by no triangle
    const SolidMesh solid = checked_solid(soup, "m.stl");
    EXPECT_EQ(solid.mesh.vertices.size(), 8u);
    EXPECT_DOUBLE_EQ(volume(solid), 8.0);
}

TEST(DegenerateTriangles, AreRemovedWithANote) {
    TriangleMesh mesh = cube;
    mesh.triangles.push_back({0, 0, 1});
    mesh.vertices.push_back(mesh.vertices[3]);
    mesh.triangles.push_back({3, 8, 5});
    const SolidMesh solid = checked_solid(mesh, "m.obj");
    EXPECT_EQ(solid.mesh.triangles.size(), 12u);
    ASSERT_EQ(solid.notes.size(), 1u);
    EXPECT_EQ(solid.notes[0], "m.obj: 2 triangles without area removed");
}

TEST(InsideOutSurfaces, AreFlippedWithANote) {
    const SolidMesh solid = checked_solid(inside_out(cube), "m.obj");
    EXPECT_DOUBLE_EQ(volume(solid), 8.0);
    ASSERT_EQ(solid.notes.size(), 1u);
    EXPECT_EQ(solid.notes[0], "m.obj: the surface was inside out; its normals are reversed");
}

TEST(InsideOutPieces, AreFlippedUnlessTheyAreCavities) {
    const TriangleMesh small = box_mesh({1.0, 1.0, 1.0});
    const TriangleMesh beside = moved(small, {5.0, 0.0, 0.0});
    const auto solid_of = [](std::vector<TriangleMesh> pieces) {
        return checked_solid(joined(pieces), "m.obj");
    };
    EXPECT_DOUBLE_EQ(volume(solid_of({cube, inside_out(beside)})), 9.0);
    EXPECT_DOUBLE_EQ(volume(solid_of({inside_out(cube), beside})), 9.0);
    EXPECT_DOUBLE_EQ(volume(solid_of({cube, inside_out(small)})), 7.0);
    // All pieces inside out, both cavity and wall.
    EXPECT_DOUBLE_EQ(volume(solid_of({inside_out(cube), small})), 7.0);
    const SolidMesh noted = solid_of({cube, inside_out(beside)});
    ASSERT_EQ(noted.notes.size(), 1u);
    EXPECT_EQ(noted.notes[0],
              "m.obj: 1 of 2 separate pieces were inside out; their normals are reversed");
}

TEST(EmptySurfaces, AreRejected) {
    // A sheet with two sides encloses nothing.
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0.1}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_NE(refusal(sheet).find("encloses no volume"), std::string::npos);
    // A cube flattened into a plane that does not pass through the origin.
    TriangleMesh flat = placed(cube, Eigen::Affine3d(Eigen::Scaling(0.1, 0.7, 0.0)));
    for (Eigen::Vector3d& v : flat.vertices) v.z() = 0.3 * v.x() + 0.1;
    EXPECT_NE(refusal(flat), "accepted");
    EXPECT_NE(refusal({}).find("no triangle has an area"), std::string::npos);
}

// A thin body is accepted: a millionth of its width is still a thickness.
TEST(ThinSolids, AreAccepted) {
    const SolidMesh solid = checked_solid(box_mesh({1.0, 1.0, 1e-6}), "m.obj");
    EXPECT_NEAR(volume(solid), 1e-6, 1e-21);
}

}  // namespace
}  // namespace poinsot
