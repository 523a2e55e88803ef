// What follows from the choices of a still.
#include "orders/still.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "refusal.h"

namespace poinsot {
namespace {

SceneRequest scene() {
    SceneRequest request;
    request.file = "scene.toml";
    request.text = "[body]\nmoments_kg_m2 = [3, 2, 1]\n[start]\nomega_rad_s = [1, 2, 3]\n";
    return request;
}

GivenOptions with_dpi(double dpi) {
    GivenOptions given;
    given.paper.dpi = dpi;
    return given;
}

GivenOptions for_journal(const std::string& journal) {
    GivenOptions given;
    given.paper.journal = journal;
    return given;
}

TEST(StillOrder, OfVectorsIsForPaperAndOfPixelsIsNot) {
    for (const std::string output : {"a.pdf", "a.svg", "a.PDF"}) {
        const StillOrder order = still_order(scene(), {}, output, {});
        EXPECT_EQ(order.still.print.dpi, default_dpi) << output;
        EXPECT_EQ(order.scene.print.dpi, default_dpi) << output;
        EXPECT_EQ(still_order(scene(), with_dpi(600.0), output, {}).still.print.dpi, 600.0);
    }
    for (const std::string output : {"", "a.png"})
        EXPECT_FALSE(still_order(scene(), {}, output, {}).still.print.dpi) << output;
}

// A motion by steps ends with the film unless an instant beyond it is asked for.
TEST(StillOrder, CoversItsInstant) {
    EXPECT_EQ(still_order(scene(), {.time_s = 99.0}, "", {}).scene.times_s,
              std::vector<double>{99.0});
    EXPECT_TRUE(still_order(scene(), {}, "", {}).scene.times_s.empty());
}

TEST(StillOrder, FollowsAJournal) {
    const StillOrder order = still_order(scene(), for_journal("iop"), "a.pdf", {});
    EXPECT_EQ(scene_of(order.scene).theme, "print");
    EXPECT_TRUE(scene_of(order.scene).panel_letters);
    EXPECT_FALSE(scene_of(order.scene).overlays);
    EXPECT_EQ(order.still.print.width_mm, 85.0);  // a column, as its author pages say
    GivenOptions keeping = for_journal("iop");
    keeping.paper.keep_text = true;
    const StillOrder with_text = still_order(scene(), keeping, "a.pdf", {});
    EXPECT_TRUE(scene_of(with_text.scene).overlays);
    EXPECT_EQ(
        refusal_message([] { still_order(scene(), {.paper = {.keep_text = true}}, "a.pdf", {}); }),
        "--keep-text: only --journal leaves text out; add --journal, or leave it out");
}

}  // namespace
}  // namespace poinsot
