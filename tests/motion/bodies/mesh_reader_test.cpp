// OBJ and STL round trips, and one-line errors with line or byte for bad files.
#include "bodies/mesh_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bodies/files/mesh_file.h"
#include "bodies/mass_properties.h"
#include "bodies/solid_meshes.h"
#include "error/error.h"
#include "mesh_files.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

// Rounds coordinates to multiples of 2^-20 m, which a float holds, so that every format keeps them
// exactly. (A cast to float and back does not work: g++ 12.2 removes it at -O2 where it
// vectorises.)
TriangleMesh rounded_to_floats(TriangleMesh mesh) {
    for (Eigen::Vector3d& v : mesh.vertices) v = (v * 1048576.0).array().round() / 1048576.0;
    return mesh;
}

// The mesh's triangles as positions, independent of the order of vertices.
std::vector<Eigen::Vector3d> corners(const TriangleMesh& mesh) {
    std::vector<Eigen::Vector3d> all;
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) all.push_back(mesh.vertices[v]);
    }
    return all;
}

template <typename Read>
std::string message_of(Read read) {
    try {
        read();
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

std::string obj_message(const std::string& text) {
    return message_of([&] { read_obj(text, "a.obj"); });
}

std::string stl_message(const std::string& bytes) {
    return message_of([&] { read_stl(bytes, "a.stl"); });
}

// A file in the test's folder, removed at the end of the test.
class TemporaryFile {
 public:
    TemporaryFile(const std::string& name, const std::string& bytes)
        : path_(fs::path(testing::TempDir()) / ("poinsot_" + std::to_string(::getpid()) + name)) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() { fs::remove(path_); }
    const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

TEST(MeshReaders, ErrorsKnowTheirPlace) {
    try {
        read_obj("v 0 0 0\nv 1 x 0\n", "a.obj");
        ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
        ASSERT_TRUE(error.place());
        EXPECT_EQ(error.place()->file, "a.obj");
        EXPECT_EQ(error.place()->line, 2);
        EXPECT_EQ(error.place()->column, 5);
    }
}

TEST(MeshReaders, RoundTripPreservesTheMesh) {
    for (const TriangleMesh& made : {torus_mesh(0.5, 0.2, 20, 12), cone_mesh(0.3, 1.0, 12),
                                     ellipsoid_mesh({1.0, 2.0, 3.0}, 4)}) {
        const TriangleMesh mesh = rounded_to_floats(made);
        const TriangleMesh obj = read_obj(mesh_files::obj_text(mesh), "a.obj");
        EXPECT_EQ(obj.vertices, mesh.vertices);
        EXPECT_EQ(obj.triangles, mesh.triangles);
        for (const std::string& file :
             {mesh_files::ascii_stl(mesh), mesh_files::binary_stl(mesh)}) {
            const TriangleMesh stl = read_stl(file, "a.stl");
            EXPECT_EQ(stl.vertices.size(), mesh.vertices.size());
            EXPECT_EQ(corners(stl), corners(mesh));
        }
    }
}

TEST(ObjReader, AcceptsEveryCornerSyntax) {
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n";
    const TriangleMesh expected = read_obj(head + "f 1 2 3\n", "a.obj");
    EXPECT_EQ(expected.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
    for (const char* face :
         {"f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f -3 -2 -1",
          "f -3//-1 -2//-1 -1//-1", "  f\t1 2 \\\n 3", "f 1 2 3 # comment"}) {
        EXPECT_EQ(read_obj(head + face, "a.obj").triangles, expected.triangles) << face;
    }
    // A face may come before its vertices, and CRLF line ends are allowed.
    EXPECT_EQ(read_obj("f 1 2 3\r\n" + head, "a.obj").triangles, expected.triangles);
    EXPECT_EQ(read_obj("\xef\xbb\xbf" + head + "f 1 2 3", "a.obj").triangles, expected.triangles);
}

TEST(ObjReader, CutsPolygonsIntoFans) {
    const TriangleMesh mesh =
        read_obj("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n", "a.obj");
    EXPECT_EQ(mesh.triangles,
              (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(ObjReader, IgnoresOtherLines) {
    const TriangleMesh mesh = read_obj(
        "mtllib a.mtl\ng x\nusemtl y\nv 0 0 0 1 0.5 0.5 0.5\nv +1.0 0 0\nv 0 1e-999 0\nl 1 2\n"
        "# v 9 9 9 \\\ns 1\ncurv 0 1 \\\n v 7 7 7\nf 1 2 3\n",
        "a.obj");
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d::Zero());
}

TEST(ObjReader, ErrorsNameLineAndColumn) {
    const struct {
        const char* text;
        const char* message;
    } cases[] = {
        {"", "a.obj: no faces"},
        {"v 0 0 0\n", "a.obj: no faces"},
        {"v 0 0\n", "a.obj:1:6: a coordinate is missing"},
        {"v 0 x 0\n", "a.obj:1:5: \"x\" is not a number"},
        {"v 0 1.5.2 0\n", "a.obj:1:5: \"1.5.2\" is not a number"},
        {"v 0 +-1 0\n", "a.obj:1:5: \"+-1\" is not a number"},
        {"v 0 nan 0\n", "a.obj:1:5: \"nan\" is not a coordinate"},
        {"v 0 -inf 0\n", "a.obj:1:5: \"-inf\" is not a coordinate"},
        {"v 0 1e999 0\n", "a.obj:1:5: \"1e999\" is not a coordinate"},
        {"v 0 1e31 0\n", "a.obj:1:5: \"1e31\" is not a coordinate within ±1e+30 m; scale"},
        {"v 0 0 0\n# é\nf 1 2\n", "a.obj:3:1: a face has 2 corners"},
        {"v 0 0 0\nf\n", "a.obj:2:1: a face has 0 corners"},
        {"v 0 0 0\nf 1 0 1\n", "a.obj:2:5: vertices are counted from 1"},
        {"v 0 0 0\nf 1 1 2\n", "a.obj:2:7: there is no vertex 2: the file has 1"},
        {"v 0 0 0\nf 1 -2 1\n", "a.obj:2:5: there is no vertex -2: 1 stand"},
        {"v 0 0 0\nf 1 9999999999 1\n", "a.obj:2:5: there is no vertex 9999999999"},
        {"v 0 0 0\nf 1 99999999999999999999 1\n", "a.obj:2:5: \"99999999999999999999\" is not a"},
        {"v 0 0 0\nf 1 1/x 1\n", "a.obj:2:5: \"1/x\" is not a corner of a face"},
        {"v 0 0 0\nf 1 1/1/1/1 1\n", "a.obj:2:5: \"1/1/1/1\" is not a corner"},
        {"v 0 0 0\nf 1 1.0 1\n", "a.obj:2:5: \"1.0\" is not a corner"},
        {"v 0 0 0\nf 1 \x1b[31m 1\n", "a.obj:2:5: \"\\u001b[31m\" is not a corner"},
    };
    for (const auto& c : cases) {
        const std::string message = obj_message(c.text);
        EXPECT_TRUE(message.starts_with(c.message)) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message << " says not what to do";
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST(StlReader, DistinguishesAsciiFromBinaryBySize) {
    const TriangleMesh box = box_mesh({1.0, 2.0, 3.0});
    // A binary file whose header begins like an ASCII file.
    std::string bytes = mesh_files::binary_stl(box);
    bytes.replace(0, 5, "solid");
    EXPECT_EQ(corners(read_stl(bytes, "a.stl")), corners(box));
    std::string text = mesh_files::ascii_stl(box);
    std::ranges::transform(text, text.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    });
    EXPECT_EQ(corners(read_stl(text, "a.stl")), corners(box));
}

TEST(StlReader, ErrorsNameLineOrByte) {
    const std::string binary = mesh_files::binary_stl(box_mesh({1.0, 1.0, 1.0}));
    std::string not_finite = binary;
    // The second coordinate of the third facet's first corner.
    not_finite.replace(84 + 2 * 50 + 12 + 4, 4, "\x00\x00\xc0\x7f"s);
    std::string many = binary;
    many.replace(80, 4, "\xff\xff\xff\xff"s);
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
    const struct {
        std::string bytes;
        const char* message;
    } cases[] = {
        {"", "a.stl: 0 bytes are neither"},
        {"so", "a.stl: 2 bytes are neither"},
        {binary.substr(0, 83), "a.stl: 83 bytes are neither"},
        {binary.substr(0, 200), "a.stl: byte 80: says 12 triangles, which take 684 bytes"},
        {binary + "x", "a.stl: byte 80: says 12 triangles"},
        {many, "a.stl: byte 80: says 4294967295 triangles, which take 214748364834 bytes"},
        {not_finite, "a.stl: byte 200: coordinate nan of triangle 3 is not within"},
        {std::string(84, '\0'), "a.stl: no triangles"},
        {"solid x\nendsolid x\n", "a.stl: no triangles"},
        {"solid x\n", "a.stl:2:1: the end of the file where \"facet\""},
        {"solid x\nfacets\n", "a.stl:2:1: \"facets\" where \"facet\""},
        {"solid x\nfacet normal 0 0\nouter", "a.stl:3:1: a facet's normal has three"},
        {"solid x\n" + facet + "vertex 1 0\nvertex 0 0 0\n",
         "a.stl:6:1: \"vertex\" is not a number"},
        {"solid x\n" + facet, "a.stl:5:1: the end of the file where \"vertex\""},
        {"solid x\n" + facet + "vertex 1 0 inf", "a.stl:5:12: \"inf\" is not a coordinate"},
        {"solid x\nendsolid x\nrubbish", "a.stl:3:1: \"rubbish\" where \"solid\""},
    };
    for (const auto& c : cases) {
        const std::string message = stl_message(c.bytes);
        EXPECT_TRUE(message.starts_with(c.message)) << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message << " says not what to do";
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

SolidMesh solid_in(const fs::path& file) {
    return read_solid(bytes_of_mesh_file(file), file.string());
}

TEST(MeshFiles, BecomeSolids) {
    const TriangleMesh box = box_mesh({1.0, 2.0, 3.0});
    const TemporaryFile obj("a.OBJ", mesh_files::obj_text(inside_out(box)));
    const SolidMesh solid = solid_in(obj.path());
    EXPECT_DOUBLE_EQ(mass_properties(solid.mesh).volume_m3, 6.0);
    ASSERT_EQ(solid.notes.size(), 1u);
    EXPECT_NE(solid.notes[0].find("inside out"), std::string::npos);
    const TemporaryFile stl("a.stl", mesh_files::binary_stl(box));
    EXPECT_DOUBLE_EQ(mass_properties(solid_in(stl.path()).mesh).volume_m3, 6.0);
}

TEST(MeshFiles, ErrorsAreOneLine) {
    const TemporaryFile empty("e.obj", "");
    const TemporaryFile text("e.txt", "v 0 0 0\n");
    const TemporaryFile large("l.stl", "");
    fs::resize_file(large.path(), largest_mesh_bytes + 1);  // sparse: uses no disk space
    const struct {
        fs::path file;
        const char* message;
    } cases[] = {
        {"/nowhere/a.obj", "no such file; "},
        {fs::path(testing::TempDir()) / "..obj", "no such file; "},
        {empty.path(), "the file is empty; "},
        {text.path(), "not a mesh that can be read; "},
        {large.path(), "256 MiB, more than 256; simplify"},
    };
    for (const auto& c : cases) {
        const std::string message = message_of([&] { solid_in(c.file); });
        EXPECT_TRUE(message.starts_with(c.file.string() + ": " + c.message)) << message;
    }
    const fs::path folder = fs::path(testing::TempDir()) / "poinsot_folder.obj";
    fs::create_directory(folder);
    EXPECT_NE(message_of([&] { solid_in(folder); }).find("this is a folder"), std::string::npos);
    fs::remove(folder);
}

// For any bytes, a reader returns a mesh with valid indices and finite vertices, or throws
// InputError.
void expect_mesh_or_error(const std::string& bytes) {
    for (const auto read : {read_obj, read_stl}) {
        try {
            const TriangleMesh mesh = read(bytes, "x");
            RC_ASSERT(!mesh.triangles.empty() || read == read_stl);
            for (const auto& t : mesh.triangles) {
                for (const std::uint32_t v : t) RC_ASSERT(v < mesh.vertices.size());
            }
            for (const Eigen::Vector3d& v : mesh.vertices) RC_ASSERT(v.allFinite());
            const SolidMesh solid = checked_solid(mesh, "x");
            RC_ASSERT(mass_properties(solid.mesh).volume_m3 > 0.0);
        } catch (const InputError& e) {
            RC_ASSERT(std::string(e.what()).find('\n') == std::string::npos);
        }
    }
}

TEST(MeshReaders, SurviveRandomBytes) {
    EXPECT_TRUE(rc::check([] {
        const auto bytes = *rc::gen::arbitrary<std::vector<char>>();
        expect_mesh_or_error({bytes.begin(), bytes.end()});
    }));
}

// Words of the formats in random order reach more of the readers' code than random bytes do.
TEST(MeshReaders, SurviveRandomWords) {
    EXPECT_TRUE(rc::check([] {
        const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element(
            "v"s, "f"s, "\n"s, "0"s, "1"s, "-1"s, "2"s, "3"s, "4"s, "1e300"s, "nan"s, "1/2/3"s,
            "1//1"s, "\\\n"s, "#"s, "solid"s, "facet"s, "normal"s, "outer"s, "loop"s, "vertex"s,
            "endloop"s, "endfacet"s, "endsolid"s));
        std::string text;
        for (const std::string& word : words) text += word + " ";
        expect_mesh_or_error(text);
        expect_mesh_or_error("solid \n" + text);
    }));
}

// A good file with one byte changed.
TEST(MeshReaders, SurviveDamagedFiles) {
    const TriangleMesh mesh = rounded_to_floats(cone_mesh(0.5, 1.0, 4));
    for (const std::string& good :
         {mesh_files::obj_text(mesh), mesh_files::ascii_stl(mesh), mesh_files::binary_stl(mesh)}) {
        EXPECT_TRUE(rc::check([&] {
            std::string bad = good;
            const auto at = *rc::gen::inRange<std::size_t>(0, bad.size());
            bad[at] = *rc::gen::arbitrary<char>();
            expect_mesh_or_error(bad);
        }));
    }
}

}  // namespace
}  // namespace poinsot
