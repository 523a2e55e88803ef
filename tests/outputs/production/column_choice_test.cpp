// One meaning of ω₁: a body whose tensor is given in axes that are not principal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/stage/live_values.h"
#include "drawing/stage/stage.h"
#include "production/sampling/sample_table.h"
#include "production/session/session.h"
#include "scene/files/load_scene.h"
#include "text/nearest.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// Principal moments 2 and 4 along (4, 3, 0)/5 and (−3, 4, 0)/5.
const std::string turned_about_z = R"(
[body]
tensor_kg_m2 = [[2.72, -0.96, 0.0], [-0.96, 3.28, 0.0], [0.0, 0.0, 3.0]]
[start]
omega_rad_s = [0.5, 0.2, 0.7]
[[panels]]
kind = "plot"
quantity = "omega"
)";

TEST(ColumnChoice, OmegaHasOneMeaningInChartsCaptionsAndColumns) {
    const Session session = session_of(parse_scene(turned_about_z, "a.toml"), {installed_fonts()});
    const std::vector<std::string> names{"omega", "omega_body"};
    const SampleTable table = sample_table(session.motion, columns_named(session.motion, names),
                                           std::vector{0.0, 1.7}, "--times");
    ASSERT_EQ(table.headings[0], "omega_1_rad_s");
    ASSERT_EQ(table.headings[3], "omega_body_1_rad_s");
    const Stage stage(
        session.scene, theme_of(session.scene), session.motion,
        {.width_px = 320, .height_px = 180, .last_time_s = 2.0, .fonts = installed_fonts()});
    for (const std::size_t row : {0U, 1U}) {
        const FrameInput instant{session.motion.sample(row == 0 ? 0.0 : 1.7, {.attitude = false})};
        const PlotValues charted =
            plot_quantity_of(stage.context(), "omega").values(stage.context(), instant);
        const std::vector<LiveValue> captioned = live_values(session.scene, instant);
        const double* columns = table.values.data() + 6 * row;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(charted[i], columns[i]) << i;
            for (const auto& [name, column] :
                 {std::pair{"omega", i}, std::pair{"omega_body", i + 3}}) {
                const std::string number = fmt::format("{}_{}_rad_s", name, i + 1);
                EXPECT_EQ(find_row(captioned, number)->value, columns[column]) << number;
            }
        }
    }
    // Computed by hand for t = 0.
    EXPECT_NEAR(table.values[0], 0.52, 1e-15);
    EXPECT_NEAR(table.values[1], -0.14, 1e-15);
    EXPECT_EQ(table.values[3], 0.5);
    EXPECT_EQ(table.values[4], 0.2);
}

}  // namespace
}  // namespace poinsot
