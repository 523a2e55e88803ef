// Type beside what it names: labels that keep off each other and never jump between video frames.
//
// The place of a label is a continuous function of the picture alone, not of earlier frames, so
// that any frame drawn by itself is the frame of the film.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "drawing/type/least_sizes.h"
#include "shapes/views.h"
#include "typeset/typesetter.h"

namespace poinsot {

// A string that has been set: its mask and where its ink lies from the pen, in pixels of the
// picture that is drawn.
struct SetType {
    const GlyphMask* mask = nullptr;
    int left_px = 0;
    double baseline_px = 0.0;

    // Of the ink's box: whole pixels of the picture that is looked at.
    double width_px() const { return mask->width_px(); }
    double height_px() const { return mask->height_px(); }
};

// Where on paper there is no room for all type, what has a higher rank is left out first; what is
// named in the picture is not, and without room for it the picture is refused.
enum LabelRank {
    rank_of_names = 0,
    rank_of_headings = 1,
    rank_of_title = 2,
    rank_of_charts = 3,
    rank_of_clock = 4,
    rank_of_caption = 5
};

// Type of fewer pixels an em is left out: its small letters would be one pixel high.
inline constexpr double least_legible_px = 3.0;

// Sets type once a string and size, and keeps the masks for the stage's life. What is too small to
// be read gets an empty mask; what cannot be set is refused at any size.
class TypeCase {
 public:
    // For pictures drawn with samples × samples to a pixel: styles are in pixels of the picture
    // drawn, and masks are set for the one that is looked at. What would be smaller than `least` is
    // set larger, and all of a string whose sub- and superscripts would be.
    explicit TypeCase(int samples = 1, const LeastSizes& least = {})
        : samples_(samples), least_(least.times(1.0 / samples)) {}

    SetType set(std::string_view text, const TypeStyle& style);

    // For type that changes with every frame: the mask goes with the view.
    SetType set_live(std::string_view text, const TypeStyle& style, View& view) const;

    // A band on which type is read, as dense as can be at its top or at its foot and fading out
    // over the other half. Pixels of the picture drawn, whole ones of that which is looked at.
    SetType band(double width_px, double height_px, bool dense_at_top);

    // The smallest em of what was set and kept, in pixels of the picture drawn; infinite for none.
    double least_size_px() const;

    // What stood in for characters that the fonts of labels and captions lack.
    const Typesetter& typesetter() const { return typesetter_; }

 private:
    // Leaves in the style what it was set by, in pixels of the mask.
    TypesetMask set_legible(std::string_view text, TypeStyle& style) const;
    SetType keep(TypesetMask&& set, std::deque<GlyphMask>& masks) const;
    SetType set_among(std::deque<GlyphMask>& masks, std::string_view text,
                      const TypeStyle& style) const;

    int samples_;
    LeastSizes least_;  // of the masks' pixels
    Typesetter typesetter_;
    std::deque<GlyphMask> masks_;
    std::map<std::tuple<std::string, double, int, double>, SetType> known_;
};

// A label that wants to stand beside a point, on the side that `away` names.
struct LabelWish {
    SetType type;
    Eigen::Vector2d anchor_px = Eigen::Vector2d::Zero();
    // Picture axes, y down; longer than about 1 is far enough, shorter comes nearer to the anchor,
    // and zero stands to the right of it.
    Eigen::Vector2d away{1.0, 0.0};
    double gap_px = 6.0;
    Colour colour;
    double opacity = 1.0;
    // What it names, view axes: there ends the leader of a label that had to stand elsewhere.
    std::optional<Eigen::Vector3d> at{};
    // To which side of another's shaft it goes that runs through its place: 1, clockwise from the
    // shaft's direction, or -1; 0 keeps off no shaft.
    int side = 0;
};

// Adds the wishes as labels of the view: each at its place, then off the shafts of arrows that it
// does not name, pushed apart where they would cover each other, and kept inside the view. Those
// that come to stand away from their places have leaders, lines along `segment` (from the origin to
// x; none: no leaders).
void place_labels(const std::vector<LabelWish>& wishes, const Colour& halo, double halo_px,
                  View& view, const CurveGeometry* segment = nullptr);

}  // namespace poinsot
