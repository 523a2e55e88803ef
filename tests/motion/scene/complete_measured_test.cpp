// [measured]: what is read from its table, and what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "mesh_folder.h"
#include "scene/files/load_scene.h"
#include "scene/scene_error.h"
#include "scene/write_scene.h"
#include "scene_text.h"

namespace poinsot {
namespace {

class Measured : public testing::Test {
 protected:
    static std::string naming(const std::string& file) {
        return a_scene + "[measured]\nfile = \"" + file + "\"\n";
    }
    MeshFolder folder_;
};

TEST_F(Measured, IsReadAndWrittenByItsName) {
    const Scene scene = scene_of(naming("gyro.csv"));
    EXPECT_TRUE(scene.measured.motion.has_omega);
    EXPECT_FALSE(scene.measured.motion.has_attitude);
    EXPECT_TRUE(scene.notes.empty());
    EXPECT_NE(to_toml(scene).find("[measured]\nfile = \"gyro.csv\"\n"), std::string::npos);
    // A scene without one does not mention it.
    EXPECT_EQ(to_toml(scene_of(a_scene)).find("measured"), std::string::npos);
}

TEST_F(Measured, GetsOmegaFromAttitudesAndSaysSo) {
    // Half a turn about z in one second.
    folder_.write("scenes/q.csv",
                  "t,qw,qx,qy,qz\n0,1,0,0,0\n0.5,0.70710678,0,0,0.70710678\n"
                  "1,0,0,0,1\n");
    const Scene scene = scene_of(naming("q.csv"));
    EXPECT_TRUE(scene.measured.has_derived_omega);
    for (const MeasuredRow& row : scene.measured.motion.rows)
        EXPECT_LT((row.omega_body - Eigen::Vector3d(0.0, 0.0, std::acos(-1.0))).norm(), 1e-7);
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0],
              "q.csv has no ω; it is computed from the differences of its attitudes");
}

TEST_F(Measured, NotesSaturation) {
    folder_.write("scenes/s.csv", "t,wx,wy,wz\n0,0.5,2,3\n1,4,2,3\n2,4,2,3\n3,4,2,3\n4,3,2,3\n");
    const Scene scene = scene_of(naming("s.csv"));
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_EQ(scene.notes[0],
              "s.csv: omega_x stays at 4 rad/s for 3 rows from 1 s on: the sensor's limit?");
}

TEST_F(Measured, IsRefusedWithBothPlaces) {
    folder_.write("scenes/cut.csv", "t,wx,wy,wz\n0,1,2,3\n1,1,2\n");
    EXPECT_TRUE(refusal(naming("cut.csv"))
                    .starts_with("scenes/a.toml:7:1: scenes/cut.csv:3:6: the row has 3 cells"))
        << refusal(naming("cut.csv"));
    EXPECT_EQ(refusal(naming("missing.csv")),
              "scenes/a.toml:7:1: scenes/missing.csv: no such file; name a table of text (CSV)");
    EXPECT_EQ(refusal(a_scene + "[measured]\n"),
              "scenes/a.toml:6:2: measured.file is missing; name a table in the scene's folder");
    EXPECT_EQ(refusal(naming("")),
              "scenes/a.toml:7:1: measured.file is missing; name a table in the scene's folder");
    // Outside of the scene's folder, as for meshes and pictures.
    folder_.write("outside.csv", gyro_csv);
    EXPECT_NE(refusal(naming("../outside.csv")).find("does not lie in the scene's folder"),
              std::string::npos);
    EXPECT_NO_THROW(parse_scene(naming("../outside.csv"), "scenes/a.toml", {},
                                files_of_folder(OutsideFiles::allowed)));
}

TEST_F(Measured, IsRefusedIfNoOmegaFollows) {
    folder_.write("scenes/one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n");
    EXPECT_NE(refusal(naming("one.csv")).find("one attitude, from which no ω follows"),
              std::string::npos)
        << refusal(naming("one.csv"));
    folder_.write("scenes/near.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1e-320,0,1,0,0\n2e-320,1,0,0,0\n");
    EXPECT_NE(refusal(naming("near.csv")).find("too close in time to differentiate"),
              std::string::npos)
        << refusal(naming("near.csv"));
}

TEST_F(Measured, IsRefusedIfItIsTooLarge) {
    std::string table = "t,wx,wy,wz\n";
    for (int i = 0; table.size() <= most_table_bytes; ++i)
        table += std::to_string(i) + ",1.2345678901234567890,2,3\n";
    folder_.write("scenes/long.csv", table);
    EXPECT_EQ(refusal(naming("long.csv")),
              "scenes/a.toml:7:1: long.csv is larger than 16 MiB; cut it to the time that the film "
              "shows");
}

}  // namespace
}  // namespace poinsot
