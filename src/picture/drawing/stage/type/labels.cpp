#include "drawing/stage/type/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numerics/smooth_step.h"
#include "shapes/identity.h"
#include "shapes/outlines.h"
#include "shapes/projection.h"

namespace poinsot {

namespace {

// 1 for a point in the view, falling to 0 a little way outside: a label fades out as its point
// leaves the view.
double nearness_to_view(const Eigen::Vector2d& at_px, const View& view) {
    const double reach_px = 0.06 * view.height_px;
    const double outside_px =
        std::max({view.x_px - at_px.x(), at_px.x() - view.x_px - view.width_px,
                  view.y_px - at_px.y(), at_px.y() - view.y_px - view.height_px, 0.0});
    return std::clamp(1.0 - outside_px / reach_px, 0.0, 1.0);
}

// Moves a box off another that does not move, as far as both treated as ellipses overlap. The
// nearer than `blind` their middles are, the less: what passes right under a label leaves it in its
// place.
void push_off(const LabelBox& fixed, double opacity, double blind, LabelBox& box) {
    const Eigen::Vector2d sum = 1.2 * (fixed.half_px + box.half_px);
    const Eigen::Vector2d between = box.centre_px - fixed.centre_px;
    const double nearness = between.cwiseQuotient(sum).norm();
    if (!(nearness < 1.0)) return;
    box.centre_px += opacity * (1.0 - nearness) * between / std::max(nearness, blind);
}

// An arrow's projection to the picture.
struct Shaft {
    Eigen::Vector3d tip, direction;  // a unit vector
    Eigen::Vector2d from, along;     // px; `along` is a unit vector
    double length_px = 0.0, half_px = 0.0, opacity = 1.0;
    LabelBox head;
};

std::vector<Shaft> shafts_of(const View& view) {
    std::vector<Shaft> shafts;
    shafts.reserve(view.arrows.size());
    for (const Arrow& arrow : view.arrows) {
        const Eigen::Vector2d from = project(view, arrow.tail).px;
        const Eigen::Vector2d way = project(view, arrow.tip).px - from;
        const double length = way.norm();
        if (!(length > 0.0)) continue;
        const Eigen::Vector3d direction = (arrow.tip - arrow.tail).stableNormalized();
        const double head_length_px = std::min(arrow.head_length_px, length);
        const double radius = 0.5 * std::max(arrow.head_px, head_length_px);
        shafts.push_back({arrow.tip,
                          direction,
                          from,
                          way / length,
                          length,
                          0.5 * arrow.shaft_px,
                          std::clamp(arrow.opacity, 0.0, 1.0),
                          {from + (1.0 - 0.5 * head_length_px / length) * way,
                           Eigen::Vector2d::Constant(radius)}});
    }
    return shafts;
}

// Moves a box to its side of shafts that pass through it, of arrows nearly parallel to its own.
// Other shafts pass under the label: avoiding them would make it move back and forth. The label
// starts to move while the shaft approaches, and is clear of it when the shaft reaches the
// requested position.
void keep_off(const std::vector<Shaft>& shafts, const LabelRequest& request, LabelBox& box) {
    constexpr double clear = 1.15;                        // of the box's size
    constexpr double passes = 0.90, accompanies = 0.985;  // cosines: 26° and 10°
    const auto own = std::find_if(shafts.begin(), shafts.end(), [&request](const Shaft& shaft) {
        return request.at && (*request.at - shaft.tip).isZero(0.0);
    });
    if (own == shafts.end()) return;
    for (const Shaft& shaft : shafts) {
        if (&shaft == &*own) continue;
        const double company =
            smooth_step((own->direction.dot(shaft.direction) - passes) / (accompanies - passes));
        const Eigen::Vector2d normal =
            request.side * Eigen::Vector2d(-shaft.along.y(), shaft.along.x());
        const Eigen::Vector2d from = box.centre_px - shaft.from;
        const double reach_along = box.half_px.dot(shaft.along.cwiseAbs());
        const double past = from.dot(shaft.along);
        // An arrow is wider at its head.
        const double at_head = smooth_step((past - shaft.length_px) / reach_along + 1.0 +
                                           shaft.head.half_px.x() / reach_along);
        const double half_px = shaft.half_px + at_head * (shaft.head.half_px.x() - shaft.half_px);
        const double reach =
            clear * box.half_px.dot(normal.cwiseAbs()) + half_px + 0.3 * request.gap_px;
        const double aside = from.dot(normal);
        const double beside = std::min(past, shaft.length_px - past) + reach_along;
        const double move =
            std::min(reach * smooth_step(1.0 + 0.5 * aside / reach), std::max(reach - aside, 0.0));
        box.centre_px +=
            company * move * smooth_step(beside / reach_along) * shaft.opacity * normal;
    }
}

// Sets text at the given size, or larger, so that no sub- or superscript is smaller than
// `script_px`; on return the style has the size used.
TypesetMask set_no_smaller(const Typesetter& typesetter, std::string_view text, double script_px,
                           TypeStyle& style) {
    TypesetMask set = typesetter.set(text, style);
    double least_px = script_px;
    for (const SetGlyph& glyph : set.glyphs) least_px = std::min(least_px, glyph.em_px);
    if (least_px >= script_px) return set;
    style.size_px *= script_px / least_px;
    return typesetter.set(text, style);
}

}  // namespace

TypesetMask TextCache::set_legible(std::string_view text, TypeStyle& style) const {
    style.size_px = std::max(style.size_px / samples_, least_.type_px);
    style.max_width_px /= samples_;
    if (style.size_px >= least_legible_px || !(style.size_px > 0.0))
        return set_no_smaller(typesetter_, text, least_.script_px, style);
    style.size_px = least_legible_px;
    typesetter_.measure(text, style);
    return {};
}

TextBlock TextCache::keep(TypesetMask&& set, std::deque<GlyphMask>& masks) const {
    GlyphMask& mask = masks.emplace_back();
    mask.id = next_identity();
    mask.width = set.width;
    mask.height = set.height;
    mask.samples = samples_;
    mask.coverage = std::move(set.coverage);
    mask.tints = std::move(set.tints);
    for (const SetGlyph& glyph : set.glyphs)
        mask.letters.push_back(
            {glyph.font_file, glyph.glyph, glyph.x_px, glyph.baseline_px, glyph.em_px, glyph.tint});
    for (const SetRule& rule : set.rules)
        mask.rules.push_back({rule.left_px, rule.top_px, rule.width_px, rule.height_px});
    return {&mask, samples_ * set.left_px, samples_ * set.baseline_px};
}

TextBlock TextCache::set_among(std::deque<GlyphMask>& masks, std::string_view text,
                               const TypeStyle& style) const {
    TypeStyle used = style;
    TypesetMask set = set_legible(text, used);
    const bool is_formula = style.mode == TypeMode::math;
    SetText source{std::string(text), is_formula, used.size_px, set.baseline_px,
                   is_formula ? 0.0 : used.max_width_px};
    const TextBlock type = keep(std::move(set), masks);
    masks.back().source = std::move(source);
    return type;
}

TextBlock TextCache::set(std::string_view text, const TypeStyle& style) {
    const auto key = std::make_tuple(std::string(text), style.size_px, static_cast<int>(style.mode),
                                     style.max_width_px, style.terms != nullptr);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    const TextBlock type = set_among(masks_, text, style);
    known_.emplace(key, type);
    return type;
}

double TextCache::balanced_width_px(std::string_view text, const TypeStyle& style) const {
    TypeStyle tried = style;  // then as it is set
    set_legible(text, tried);
    if (tried.size_px < least_legible_px) return style.max_width_px;
    const int n_lines = typesetter_.measure(text, tried).n_lines;
    if (n_lines < 2) return style.max_width_px;
    double low = 0.5 * tried.max_width_px, high = tried.max_width_px;
    constexpr int n_rounds = 10;
    for (int round = 0; round < n_rounds; ++round) {
        tried.max_width_px = 0.5 * (low + high);
        const TypeExtent extent = typesetter_.measure(text, tried);
        const bool fits = extent.n_lines <= n_lines && extent.width <= tried.max_width_px;
        (fits ? high : low) = tried.max_width_px;
    }
    // With space for wider digits.
    constexpr double slack = 1.01;
    return std::min(style.max_width_px, slack * high * samples_);
}

double TextCache::least_size_px() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [key, type] : known_)
        if (type.mask->width > 0) least = std::min(least, std::get<1>(key));
    return least;
}

TextBlock TextCache::set_live(std::string_view text, const TypeStyle& style, View& view) const {
    return set_among(view.live_masks, text, style);
}

double LabelBox::length_inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    const Eigen::Vector2d way = to - from;
    double first = 0.0, last = 1.0;
    for (int i = 0; i < 2; ++i) {
        const double low = centre_px[i] - half_px[i] - from[i];
        const double high = centre_px[i] + half_px[i] - from[i];
        if (std::abs(way[i]) < 1e-9) {
            if (low > 0.0 || high < 0.0) return 0.0;
            continue;
        }
        const double a = low / way[i], b = high / way[i];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return std::max(0.0, last - first) * way.norm();
}

double LabelBox::shared_with(const LabelBox& other) const {
    const Eigen::Vector2d both =
        (half_px + other.half_px - (centre_px - other.centre_px).cwiseAbs())
            .cwiseMin(2.0 * half_px)
            .cwiseMin(2.0 * other.half_px);
    if (!(both.minCoeff() > 0.0)) return 0.0;
    return both.prod() / (4.0 * std::min(half_px.prod(), other.half_px.prod()));
}

LabelBox label_box(const Label& label) {
    const Eigen::Vector2d half =
        0.5 * Eigen::Vector2d(label.mask->width_px(), label.mask->height_px());
    return {label.top_left_px + half, half, label.opacity};
}

void add_leader(const Leader& leader, double opacity, const CurveGeometry* segment, View& view) {
    if (!(opacity > 0.0)) return;
    const Eigen::Vector2d nearest = leader.to.nearest(leader.from_px);
    const Eigen::Vector2d way = nearest - leader.from_px;
    if (!(way.norm() > 0.0)) return;
    const Projected anchor = project(view, leader.at);
    const Eigen::Matrix3d axes = camera_axes(view.camera);
    const Eigen::Vector3d along =
        units_per_pixel(view, anchor.depth) * (axes.col(0) * way.x() - axes.col(1) * way.y());
    Curve line;
    line.geometry = segment;
    line.placement.linear() << along, along.norm() * axes.col(2).cross(along).normalized(),
        along.norm() * axes.col(2);
    line.placement.translation() = leader.at;
    line.width_px = leader.width_px;
    line.colour = leader.colour;
    line.opacity = 0.85 * opacity;
    line.occlusion = Occlusion::none;
    line.name = leader.name;
    view.curves.push_back(line);
}

namespace {

// The leader of a vector's label: where its distance exceeds the requested one.
void add_leader_of(const LabelRequest& request, const Label& label, double before_px,
                   const LabelRules& rules, View& view) {
    const LabelBox box = label_box(label);
    const double distance = (box.nearest(request.anchor_px) - request.anchor_px).norm();
    const double height = 2.0 * box.half_px.y();
    double presence = smooth_step((distance - before_px - 0.35 * height) / (0.4 * height));
    if (rules.is_still) presence = whole_or_absent(presence);
    add_leader({.at = *request.at,
                .from_px = request.anchor_px,
                .to = box,
                .colour = request.colour,
                .width_px = 0.4 * rules.halo_px,
                .name = {request.name.element, request.name.number, "leader"}},
               presence * label.opacity, rules.segment, view);
}

// A label while it is placed.
struct PlacedBox {
    LabelBox box;
    double gap_px = 0.0;  // requested distance between the named point and the label
};

// The requested place, off the shafts and heads of arrows that the label does not name.
PlacedBox requested_box(const LabelRequest& request, const std::vector<Shaft>& shafts) {
    const Eigen::Vector2d half =
        0.5 * Eigen::Vector2d(request.type.width_px(), request.type.height_px());
    // The distance is that of an ellipse about the box: smooth in the direction. If the direction
    // vanishes (an arrow that points at the eye), it blends into "to the right". No function of the
    // direction alone is continuous there: the box also moves nearer to the anchor.
    const Eigen::Vector2d leaning = request.away + Eigen::Vector2d(0.2, 0.0);
    const double length = std::max(leaning.norm(), 1e-9);
    const Eigen::Vector2d away = leaning / length;
    const double reach = std::hypot(half.x() * away.x(), half.y() * away.y());
    const double nearness = length / std::hypot(length, 0.25);
    PlacedBox placed{{request.anchor_px + away * (nearness * (request.gap_px + reach)), half},
                     nearness * request.gap_px};
    if (request.side != 0) keep_off(shafts, request, placed.box);
    for (const Shaft& shaft : shafts)
        if (!(request.at && (*request.at - shaft.tip).isZero(0.0)))
            push_off(shaft.head, shaft.opacity, 0.5, placed.box);
    return placed;
}

// Moves overlapping pairs apart along the line between their centres; boxes are treated as
// ellipses. `weights`: the opacities of the labels. Keeps them off the text in `fixed`.
void move_apart(const std::vector<double>& weights, const std::vector<LabelBox>& fixed,
                std::vector<PlacedBox>& placed) {
    constexpr int n_rounds = 40;
    for (int round = 0; round < n_rounds; ++round) {
        for (std::size_t i = 0; i < placed.size(); ++i) {
            for (std::size_t j = i + 1; j < placed.size(); ++j) {
                LabelBox &one = placed[i].box, &other = placed[j].box;
                const Eigen::Vector2d sum = 1.25 * (one.half_px + other.half_px);
                const Eigen::Vector2d between = other.centre_px - one.centre_px;
                const double nearness = between.cwiseQuotient(sum).norm();
                // NaN for two omitted labels.
                if (!(nearness < 1.0)) continue;
                const Eigen::Vector2d push = 0.5 * (1.0 - nearness) *
                                             between.cwiseQuotient(sum).cwiseProduct(sum) /
                                             std::max(nearness, 1e-3) * weights[i] * weights[j];
                one.centre_px -= 0.5 * push;
                other.centre_px += 0.5 * push;
            }
        }
        for (PlacedBox& each : placed)
            for (const LabelBox& obstacle : fixed)
                push_off(obstacle, obstacle.opacity, 1e-3, each.box);
    }
}

// The lines of a view that a letter should not stand on.
struct Lines {
    struct Piece {
        Eigen::Vector2d from, to;  // px
        double weight = 1.0;
    };
    std::vector<Piece> pieces;

    Lines(const View& view, const std::vector<Shaft>& shafts) {
        // Shafts are thicker than curves, and name other things.
        constexpr double of_shaft = 2.0;
        constexpr int n_points = 512;
        for (const Curve& curve : view.curves) {
            if (curve.geometry == nullptr || curve.occlusion == Occlusion::none) continue;
            for (const VisiblePoint& point : outline_of(view, curve, n_points))
                pieces.push_back({point.before_px, point.px, std::clamp(curve.opacity, 0.0, 1.0)});
        }
        for (const Shaft& shaft : shafts)
            pieces.push_back(
                {shaft.from, shaft.from + shaft.length_px * shaft.along, of_shaft * shaft.opacity});
    }
    // In heights of the box.
    double inside(const LabelBox& box) const {
        double length = 0.0;
        for (const Piece& piece : pieces)
            length += piece.weight * box.length_inside(piece.from, piece.to);
        return 0.5 * length / std::max(box.half_px.y(), 1e-9);
    }
};

// In a still, puts letters that stand on lines beside these: at the place near the requested one
// with the least of lines, of other text, and of way to go. A film's letters follow what they name
// without such leaps.
void step_off_lines(const Lines& lines, const std::vector<double>& weights,
                    const std::vector<LabelBox>& fixed, const View& view,
                    std::vector<PlacedBox>& placed) {
    constexpr int n_directions = 16, n_steps = 5;
    constexpr double step = 0.4, per_way = 0.3, per_text = 20.0, touching = 0.02;
    const LabelBox whole_view{{view.x_px + 0.5 * view.width_px, view.y_px + 0.5 * view.height_px},
                              {0.5 * view.width_px, 0.5 * view.height_px}};
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const LabelBox asked = placed[i].box;
        if (!(weights[i] > 0.0) || !(asked.half_px.minCoeff() > 0.0)) continue;
        const double height_px = 2.0 * asked.half_px.y();
        const auto cost_of = [&](const LabelBox& box) {
            double text = 0.0;
            for (const LabelBox& other : fixed) text += other.opacity * box.shared_with(other);
            for (std::size_t k = 0; k < placed.size(); ++k)
                if (k != i && weights[k] > 0.0) text += box.shared_with(placed[k].box);
            const bool is_outside = ((box.centre_px - whole_view.centre_px).cwiseAbs() +
                                     box.half_px - whole_view.half_px)
                                        .maxCoeff() > 0.0;
            return lines.inside(box) + per_text * (text + (is_outside ? 1.0 : 0.0)) +
                   per_way * (box.centre_px - asked.centre_px).norm() / height_px;
        };
        if (lines.inside(asked) < touching) continue;
        double least = cost_of(asked);
        for (int n = 1; n <= n_steps; ++n)
            for (int k = 0; k < n_directions; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / n_directions;
                LabelBox box = asked;
                box.centre_px +=
                    n * step * height_px * Eigen::Vector2d(std::cos(angle), std::sin(angle));
                const double cost = cost_of(box);
                if (cost >= least) continue;
                least = cost;
                placed[i].box = box;
            }
    }
}

// The upper left corner of a label inside the view.
Eigen::Vector2d corner_in_view(const LabelRequest& request, const LabelBox& box,
                               const LabelRules& rules, const View& view) {
    const double margin =
        std::max(rules.margin_px, rules.halo_px + 2.0 * request.type.mask->samples);
    const Eigen::Vector2d corner = box.centre_px - box.half_px + request.offset_px;
    const auto keep = [margin](double value, double from, double size, double extent) {
        return std::max(from + margin, std::min(value, from + size - extent - margin));
    };
    return {keep(corner.x(), view.x_px, view.width_px, 2.0 * box.half_px.x()),
            keep(corner.y(), view.y_px, view.height_px, 2.0 * box.half_px.y())};
}

// The opacity of a label at its place: of two labels that cannot be moved apart, the later one
// fades out, and so does a label on the head of an arrow. A name may touch the head of its own
// arrow.
double opacity_at(const LabelBox& placed, const LabelRequest& request,
                  const std::vector<Shaft>& shafts, const std::vector<LabelBox>& fixed) {
    double opacity = placed.opacity;
    for (const Shaft& shaft : shafts) {
        const LabelBox core{shaft.head.centre_px, 0.3 * shaft.head.half_px};
        const bool is_own = request.at && (*request.at - shaft.tip).isZero(0.0);
        const double clearance =
            placed.distance(core) / (0.3 * shaft.head.half_px.y()) + (is_own ? 1.0 : 0.0);
        opacity *= 1.0 - shaft.opacity * (1.0 - smooth_step(clearance));
    }
    for (const LabelBox& other : fixed)
        opacity *=
            1.0 - other.opacity * smooth_step(-placed.distance(other) / (0.2 * placed.half_px.y()));
    return opacity;
}

}  // namespace

std::vector<UnplacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                        const LabelRules& rules, View& view) {
    const std::vector<Shaft> shafts = shafts_of(view);
    // Text that is placed already, off which labels are moved.
    std::vector<LabelBox> fixed = rules.overlays;
    for (const Label& label : view.labels) fixed.push_back(label_box(label));
    const auto shown = [&rules](double opacity) {
        return rules.is_still ? whole_or_absent(opacity) : opacity;
    };
    std::vector<PlacedBox> placed;
    std::vector<double> weights;
    placed.reserve(requests.size());
    weights.reserve(requests.size());
    for (const LabelRequest& request : requests) {
        placed.push_back(requested_box(request, shafts));
        weights.push_back(shown(request.opacity));
    }
    move_apart(weights, fixed, placed);
    if (rules.is_still) step_off_lines(Lines(view, shafts), weights, fixed, view, placed);

    std::vector<UnplacedLabel> left_out;
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const LabelRequest& request = requests[i];
        if (request.type.mask->width == 0) continue;
        const LabelBox& box = placed[i].box;
        const double present = request.opacity * nearness_to_view(request.anchor_px, view);
        const double asked = shown(present);
        Label label;
        label.mask = request.type.mask;
        label.top_left_px = corner_in_view(request, box, rules, view);
        label.colour = request.colour;
        label.halo_colour = rules.halo;
        label.halo_px = rules.halo_px;
        label.name = request.name;
        label.at = request.at;
        label.opacity = shown(opacity_at({label.top_left_px + box.half_px, box.half_px, asked},
                                         request, shafts, fixed));
        if (asked > 0.5 && label.opacity < 0.5) left_out.push_back({request.name});
        if (rules.is_still && present > 0.0 && !(asked > 0.0))
            left_out.push_back({request.name, false});
        if (!(label.opacity > 0.0)) continue;
        view.labels.push_back(label);
        fixed.push_back(label_box(label));
        if (rules.segment != nullptr && request.at)
            add_leader_of(request, label, placed[i].gap_px, rules, view);
    }
    return left_out;
}

}  // namespace poinsot
