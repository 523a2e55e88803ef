// Marked faces and pictures on faces: valid input, and messages about invalid input.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "image/files/png_files.h"
#include "mesh_folder.h"
#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot {

namespace {

std::string on(const std::string& face, const std::string& file) {
    return "[[object.pictures]]\nface = \"" + face + "\"\nfile = \"" + file + "\"\n";
}

const std::string a_cylinder =
    "[body]\nshape = \"cylinder\"\nsize_m = [0.1, 0.5]\nmass_kg = 1\n" + a_start;
const std::string a_ball =
    "[body]\nshape = \"ellipsoid\"\nsize_m = [1, 2, 3]\nmass_kg = 1\n" + a_start;
const std::string a_book =
    "[body]\nshape = \"box\"\nsize_m = [\"24 cm\", \"17 cm\", \"3 cm\"]\nmass_kg = \"800 g\"\n" +
    a_start + "[object]\nname = \"book\"\n";

TEST(Faces, OfBoxesBooksAndCylindersMayHavePictures) {
    const MeshFolder folder;
    for (const std::string& body : {a_body + a_start, a_book, a_cylinder})
        for (const char* face : {"+e3", "-e3"}) {
            const Scene scene = scene_of(body + on(face, "cover.png"));
            EXPECT_EQ(scene.object.pictures.at(0).image.height(), 2);
            EXPECT_EQ(to_toml(scene_of(to_toml(scene))), to_toml(scene));
        }
    EXPECT_EQ(scene_of(a_book + "marked_face = \"+e3\"\n").object.marked_face, "+e3");
}

TEST(Faces, ThatAreNotFlatAreRefused) {
    const MeshFolder folder;
    EXPECT_EQ(refusal(a_ball + "[object]\nmarked_face = \"+e1\"\n"),
              "scenes/a.toml:9:1: object.marked_face = \"+e1\": the body has no flat face there; "
              "choose a face that is flat, as a box's are, or remove it");
    EXPECT_EQ(refusal(a_cylinder + on("-e2", "cover.png")),
              "scenes/a.toml:9:1: object.pictures[0].face = \"-e2\": the body has no flat face "
              "there; choose a face that is flat, as a box's are, or remove it");
    EXPECT_NE(refusal("[[body.masses]]\nmass_kg = 1\nat_m = [1, 0, 0]\n[[body.masses]]\nmass_kg = "
                      "1\nat_m = [0, 1, 0]\n[[body.masses]]\nmass_kg = 1\nat_m = [0, 0, 1]\n" +
                      a_start + "[object]\nmarked_face = \"+e1\"\n")
                  .find("no flat face there"),
              std::string::npos);
    EXPECT_NE(refusal(a_body + a_start + "[object]\nmarked_face = \"top\"\n").find("+e1"),
              std::string::npos);
}

// Returns the message about a box with a picture, without its place.
std::string said(const std::string& keys) {
    const std::string all = refusal("[body]\nmoments_kg_m2 = [3, 2, 1]\n" + a_start + keys);
    return all.substr(all.find(": ") + 2);
}

TEST(Faces, PictureErrorsAreReportedAtTheirKey) {
    const MeshFolder folder;
    const std::string box = "[body]\nmoments_kg_m2 = [3, 2, 1]\n" + a_start;
    const std::string at = "scenes/a.toml:8:1: ";
    EXPECT_EQ(refusal(box + on("+e3", "none.png")),
              at + "scenes/none.png does not exist; name a whole PNG picture");
    EXPECT_EQ(refusal(box + on("+e3", "wedge.obj")),
              at + "scenes/wedge.obj is not a PNG picture; name a whole PNG picture");
    const std::vector<std::uint8_t> whole = encode_png(Image(64, 64));
    folder.write("scenes/cut.png", std::string(whole.begin(), whole.end() - 20));
    EXPECT_EQ(refusal(box + on("+e3", "cut.png")),
              at + "scenes/cut.png is cut short; name a whole PNG picture");
    write_png(folder.path() / "scenes/wide.png", Image(4097, 1));
    EXPECT_EQ(refusal(box + on("+e3", "wide.png")),
              at + "wide.png is 4097×1 pixels; a picture on a face has at most 4096 per side, so "
                   "make it smaller");
    write_png(folder.path() / "outside.png", Image(2, 2));
    EXPECT_EQ(refusal(box + on("+e3", "../outside.png")),
              at + "object.pictures[0].file = \"../outside.png\" does not lie in the scene's "
                   "folder; move it there, or give --allow-outside if you trust the scene");
}

TEST(Faces, ContradictionsOfPicturesAreNamed) {
    const MeshFolder folder;
    EXPECT_EQ(said("[[object.pictures]]\nfile = \"cover.png\"\n"),
              "object.pictures[0].face is missing; say where the picture is, as in face = \"+e3\"");
    EXPECT_EQ(said("[[object.pictures]]\nface = \"+e1\"\n"),
              "object.pictures[0].file is missing; name a PNG in the scene's folder");
    EXPECT_EQ(said(on("+e3", "cover.png") + on("+e3", "cover.png")),
              "object.pictures[1].face = \"+e3\" has object.pictures[0] already; choose another");
    EXPECT_EQ(said(on("+e3", "cover.png") + "up = \"-e3\"\n"),
              "object.pictures[0].up = \"-e3\" points through the face +e3; give a direction along "
              "it");
    EXPECT_EQ(said("[object]\nmarked_face = \"+e3\"\n" + on("+e3", "cover.png")),
              "object.pictures[0].face = \"+e3\" is the marked face, which it would cover; choose "
              "another, or remove object.marked_face");
}

}  // namespace

}  // namespace poinsot
