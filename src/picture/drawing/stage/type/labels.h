// Labels beside what they name: they do not overlap, and they do not jump between video frames.
//
// The position of a label is a continuous function of the picture alone, not of earlier frames, so
// that each frame can be drawn independently.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "drawing/stage/type/least_sizes.h"
#include "shapes/views.h"
#include "typeset/typesetter.h"

namespace poinsot {

// Text that has been set: its mask, and the position of its ink relative to the pen, in pixels of
// the rendered picture.
struct TextBlock {
    const GlyphMask* mask = nullptr;
    int left_px = 0;
    double baseline_px = 0.0;

    // Size of the ink's box, in final pixels.
    double width_px() const { return mask->width_px(); }
    double height_px() const { return mask->height_px(); }
};

// If text does not fit on paper, labels of higher rank are dropped first. Names of vectors are
// never dropped: if they do not fit, the picture is rejected.
enum LabelRank {
    rank_of_names = 0,   // of vectors, angles and points
    rank_of_things = 1,  // of curves and surfaces
    rank_of_headings = 2,
    rank_of_title = 3,
    rank_of_charts = 4,
    rank_of_clock = 5,
    rank_of_caption = 6
};

// Text below this size, pixels per em, is omitted: its small letters would be one pixel high.
inline constexpr double least_legible_px = 3.0;

// Sets text once per string and size, and caches the masks for the stage's lifetime. Text that is
// too small to read gets an empty mask; text that cannot be set is rejected at any size.
class TextCache {
 public:
    // For pictures rendered with samples × samples per pixel: styles are in rendered pixels, masks
    // in final pixels. Text smaller than `least` is enlarged; a string with too small sub- and
    // superscripts is enlarged as a whole.
    explicit TextCache(FontSource fonts, int samples = 1, const LeastSizes& least = {})
        : samples_(samples), least_(least.times(1.0 / samples)), typesetter_(std::move(fonts)) {}

    TextBlock set(std::string_view text, const TypeStyle& style);

    // For text that changes in every frame: the view owns the mask.
    TextBlock set_live(std::string_view text, const TypeStyle& style, View& view) const;

    // The least width in which running text has as many lines as in the width of its style: its
    // lines are of nearly equal length. The style's own where it has one line.
    double balanced_width_px(std::string_view text, const TypeStyle& style) const;

    // The smallest em size of the cached text, in rendered pixels; infinite if there is none.
    double least_size_px() const;

    // The typesetter, which records replaced characters that the fonts lack.
    const Typesetter& typesetter() const { return typesetter_; }

 private:
    // On return the style has the size used, in pixels of the mask.
    TypesetMask set_legible(std::string_view text, TypeStyle& style) const;
    TextBlock keep(TypesetMask&& set, std::deque<GlyphMask>& masks) const;
    TextBlock set_among(std::deque<GlyphMask>& masks, std::string_view text,
                        const TypeStyle& style) const;

    int samples_;
    LeastSizes least_;  // in pixels of the masks
    Typesetter typesetter_;
    std::deque<GlyphMask> masks_;
    std::map<std::tuple<std::string, double, int, double, bool>, TextBlock> known_;
};

// A requested label beside a point, on the side that `away` names.
struct LabelRequest {
    TextBlock type;
    Eigen::Vector2d anchor_px = Eigen::Vector2d::Zero();
    // Picture axes, y down. A length of 1 or more is the full distance, a smaller one brings the
    // label nearer to the anchor, and zero places it at the right of the anchor.
    Eigen::Vector2d away{1.0, 0.0};
    double gap_px = 6.0;
    Colour colour;
    double opacity = 1.0;
    // The named point, view axes: a leader leads there if the label is moved away.
    std::optional<Eigen::Vector3d> at{};
    // The side to which the label moves off another arrow's shaft through its position: 1,
    // clockwise from the shaft's direction, or -1; 0: it does not move off shafts.
    int side = 0;
    // By which the placed label is moved, as the scene's [labels] says.
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();
    ShapeName name{};
};

// The place of text in the picture, pixels.
struct LabelBox {
    Eigen::Vector2d centre_px, half_px;
    double opacity = 1.0;

    // The greater distance along both axes from a point or another box; negative if they overlap.
    double distance(const Eigen::Vector2d& px) const {
        return ((px - centre_px).cwiseAbs() - half_px).maxCoeff();
    }
    double distance(const LabelBox& other) const {
        return ((other.centre_px - centre_px).cwiseAbs() - half_px - other.half_px).maxCoeff();
    }
    Eigen::Vector2d nearest(const Eigen::Vector2d& px) const {
        return px.cwiseMax(centre_px - half_px).cwiseMin(centre_px + half_px);
    }
    // The area of the overlap as a fraction of the smaller box.
    double shared_with(const LabelBox& other) const;
    // The length of a segment inside.
    double length_inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
};
LabelBox label_box(const Label& label);

// A line from a point to the label that names it.
struct Leader {
    Eigen::Vector3d at;       // the point, view axes
    Eigen::Vector2d from_px;  // the same in the picture
    LabelBox to;
    Colour colour;
    double width_px = 1.6;
    ShapeName name{};
};
// `segment`: from the origin to x.
void add_leader(const Leader& leader, double opacity, const CurveGeometry* segment, View& view);

// Settings of all labels of a view.
struct LabelRules {
    Colour halo;
    double halo_px = 4.0;
    double margin_px = 6.0;  // from the edges of the view
    const CurveGeometry* segment = nullptr;
    std::vector<LabelBox> overlays{};
    bool is_still = false;  // labels and leaders are whole or absent
};

// The opacity in a still of a label or leader that fades in a film.
inline double whole_or_absent(double opacity) { return opacity < 0.5 ? 0.0 : 1.0; }

// A requested label that is not drawn, or less than half.
struct UnplacedLabel {
    ShapeName name;
    bool is_in_sight = true;  // false: what it names has faded out or left the view
};

// Adds the requested labels to the view: each is placed, moved off the shafts of arrows that it
// does not name, moved apart from labels that it overlaps and off the text in `overlays` and in the
// view, and kept inside the view. Labels that end up away from their requested position get
// leaders: lines along `segment` (from the origin to x; null: no leaders). Returns those
// that fade out because there is no room beside arrowheads and other labels, and in a still also
// those that what they name takes along as it fades out.
std::vector<UnplacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                        const LabelRules& rules, View& view);

}  // namespace poinsot
