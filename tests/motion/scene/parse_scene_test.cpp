// The files that a scene names, as bytes in memory.
#include "scene/parse_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "image/png.h"
#include "mesh_folder.h"
#include "scene/scene_error.h"
#include "scene_text.h"

namespace poinsot {
namespace {

const std::string dressed =
    "theme = \"own.toml\"\n[[object.pictures]]\nface = \"-e3\"\nfile = \"cover.png\"\n" + a_scene;
const std::string of_mesh = "[body]\nmesh = \"wedge.obj\"\ndensity_kg_m3 = 1.0\n" + a_start;

// Names the files that were asked for, in order.
SceneFiles in_memory(std::vector<std::string>& asked) {
    return [&asked](const NamedFile& file) {
        asked.push_back(file.key + " " + file.name);
        switch (file.kind) {
            case NamedFile::Kind::mesh:
                return FileBytes{file.name, wedge_obj};
            case NamedFile::Kind::theme:
                return FileBytes{file.name, "extends = \"dark\"\n"};
            case NamedFile::Kind::table:
                return FileBytes{file.name, gyro_csv};
            case NamedFile::Kind::picture:
                break;
        }
        const std::vector<std::uint8_t> png = encode_png(Image(3, 2));
        return FileBytes{file.name, {png.begin(), png.end()}};
    };
}

TEST(SceneFiles, ComeFromMemory) {
    std::vector<std::string> asked;
    const Scene scene = parse_scene(dressed, "a.toml", {}, in_memory(asked));
    EXPECT_EQ(scene.theme, "dark");
    ASSERT_EQ(scene.object.pictures.size(), 1u);
    EXPECT_EQ(scene.object.pictures[0].image.width(), 3);
    EXPECT_EQ(asked,
              (std::vector<std::string>{"object.pictures[0].file cover.png", "theme own.toml"}));

    asked.clear();
    const Scene wedge = parse_scene(of_mesh, "a.toml", {}, in_memory(asked));
    ASSERT_EQ(wedge.surfaces.size(), 1u);
    EXPECT_NEAR(wedge.body.mass_kg, 0.5, 1e-15);  // half of a unit cube; three roundings
    EXPECT_EQ(asked, std::vector<std::string>{"body.mesh wedge.obj"});
}

TEST(SceneFiles, OfMeasuredMotionsComeFromMemory) {
    std::vector<std::string> asked;
    const Scene scene =
        parse_scene(a_scene + "[measured]\nfile = \"gyro.csv\"\n", "a.toml", {}, in_memory(asked));
    EXPECT_EQ(scene.measured.motion.rows.size(), 2u);
    EXPECT_EQ(asked, std::vector<std::string>{"measured.file gyro.csv"});
}

TEST(SceneFiles, AreRefusedWhereNoneAreGiven) {
    try {
        parse_scene(of_mesh, "a.toml");
        ADD_FAILURE() << "accepted";
    } catch (const SceneFileError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "a.toml:2:1: body.mesh = \"wedge.obj\": no files can be read here; leave it out");
    }
}

}  // namespace
}  // namespace poinsot
