// Every shader compiles in every variant that a drawing may need.
#include "render/passes/program.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "error/error.h"
#include "pictures.h"
#include "render/passes/shader_sources.h"

namespace poinsot::testing {
namespace {

TEST(Shaders, AreAllUsed) {
    // A file that no program names is dead.
    std::set<std::string> named{
        "background.vert", "background.frag", "plane.frag",     "polygon.vert", "shadow.vert",
        "shadow.frag",     "ellipsoid.vert",  "ellipsoid.frag", "cone.frag",    "curve.vert",
        "curve.frag",      "arrow.frag",      "dot.frag",       "label.frag",   "mesh.vert",
        "mesh.frag",       "layer.frag",      "trace.frag",     "screen.vert",  "screen.frag"};
    for (const ShaderSource& source : shader_sources())
        for (const ShaderSource& other : shader_sources())
            if (other.text.find("#include \"" + std::string(source.name)) != std::string_view::npos)
                named.insert(std::string(source.name));
    for (const ShaderSource& source : shader_sources())
        EXPECT_TRUE(named.contains(std::string(source.name))) << source.name;
}

TEST(Shaders, CompileForAnyNumberOfSolids) {
    renderer();
    for (const int n_quadrics : {0, 1, 2, max_quadrics}) {
        for (const int n_flats : {0, 1, max_flats}) {
            for (const int n_meshes : {0, 1}) {
                const Solids solids{n_quadrics, n_flats, n_meshes};
                std::vector<std::string> defines = solids.defines();
                const int n = solids.n_constants();
                EXPECT_NO_THROW(PolygonProgram("arrow.frag", 17 + n, defines));
                EXPECT_NO_THROW(PolygonProgram("dot.frag", 9 + n, defines));
                defines.push_back("FADE " + std::to_string(8 + n));
                EXPECT_NO_THROW(ConstantProgram("curve.vert", "curve.frag", 10 + n, 4, defines));
                for (const int n_cones : {1, 2, 4}) {
                    defines = solids.defines();
                    defines.push_back("MEMBERS " + std::to_string(n_cones));
                    EXPECT_NO_THROW(PolygonProgram("cone.frag", 7 + 10 * n_cones + n, defines));
                }
            }
        }
    }
}

TEST(Shaders, ErrorsNameTheFile) {
    renderer();
    EXPECT_THROW(Program("no_such.vert", "background.frag"), Error);
    // plane.frag without its constants does not compile; the message names the file.
    try {
        const Program program("background.vert", "plane.frag");
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("plane.frag"), std::string::npos);
    }
}

}  // namespace
}  // namespace poinsot::testing
