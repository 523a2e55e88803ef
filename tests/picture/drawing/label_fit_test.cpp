// Text that does not fit on paper.
#include "drawing/stage/type/label_fit.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

// Words with their left sides and ranks, on one line of a page of 400 by 100 pixels.
class Line {
 public:
    void add(const char* word, double left_px, LabelRank rank, double opacity = 1.0) {
        Label label;
        label.mask = types_.set(word, {.size_px = 20.0, .mode = TypeMode::text}).mask;
        label.top_left_px = {left_px, 40.0};
        label.rank = rank;
        label.opacity = opacity;
        view_.labels.push_back(label);
    }

    // The remaining words.
    std::vector<std::string> words() const {
        Drawing drawing;
        drawing.width_px = 400;
        drawing.height_px = 100;
        View view;
        view.labels = view_.labels;
        drawing.views.push_back(std::move(view));
        leave_out_type(drawing);
        std::vector<std::string> left;
        for (const Label& label : drawing.views[0].labels) left.push_back(label.mask->source.text);
        return left;
    }

 private:
    TextCache types_{installed_fonts()};
    View view_;
};

using Words = std::vector<std::string>;

TEST(RoomForType, DropsTheHigherRank) {
    Line line;
    line.add("caption", 100.0, rank_of_caption);
    line.add("title", 110.0, rank_of_title);
    line.add("clock", 300.0, rank_of_clock);
    EXPECT_EQ(line.words(), (Words{"title", "clock"}));
}

TEST(RoomForType, DropsTheLaterOfEqualRank) {
    Line line;
    for (int k = 0; k < 4; ++k) line.add("1000", 50.0 + 30.0 * k, rank_of_charts);
    EXPECT_EQ(line.words().size(), 2u);
}

TEST(RoomForType, DropsTextOutsideThePageUnlessItIsAName) {
    Line line;
    line.add("caption", 370.0, rank_of_caption);
    line.add("L", 395.0, rank_of_names);
    EXPECT_EQ(line.words(), (Words{"L"}));
}

}  // namespace
}  // namespace poinsot
