#include "production/jobs/picture_regions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/overlay.h"
#include "error/error.h"
#include "production/session/film_plan.h"
#include "production/session/picture_setting.h"
#include "production/session/still_moment.h"
#include "production/vectors/journal.h"
#include "production/vectors/vector_still.h"
#include "render/pixel_area.h"
#include "shapes/projection.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {

namespace {

constexpr std::string_view all_labels = "labels";
// The curves of panel body beside that of the motion.
constexpr std::string_view other_polhodes = "polhodes", separatrix = "separatrix";

// Collects the rectangles of one view, in pixels of the drawing.
class BoxCollector {
 public:
    BoxCollector(const View& view, std::vector<PixelBox>& boxes)
        : projection_(view), boxes_(boxes) {}

    void add(const Label& label) {
        if (label.mask == nullptr || label.mask->width == 0) return;
        const double halo = label.halo_px;
        boxes_.push_back({label.top_left_px.x() - halo, label.top_left_px.y() - halo,
                          label.top_left_px.x() + label.mask->width_px() + halo,
                          label.top_left_px.y() + label.mask->height_px() + halo});
    }
    void add(const Curve& curve) {
        if (curve.geometry == nullptr || curve.geometry->points.size() < 2) return;
        const auto& points = curve.geometry->points;
        const std::size_t n = points.size();
        const auto n_segments = n - (curve.geometry->closed ? 0 : 1);
        const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(curve.first)));
        const auto last = static_cast<std::size_t>(
            std::clamp(std::ceil(curve.last), 0.0, static_cast<double>(n_segments)));
        for (std::size_t i = first; i < last; ++i)
            add_segment(curve.placement * points[i], curve.placement * points[(i + 1) % n],
                        0.5 * curve.width_px);
    }
    void add(const Arrow& arrow) {
        add_segment(arrow.tail, arrow.tip, 0.5 * std::max(arrow.head_px, arrow.shaft_px));
    }
    void add(const Dot& dot) { add_segment(dot.at, dot.at, dot.radius_px + dot.rim_px); }
    void add(const Ellipsoid& ellipsoid) {
        PixelBox box;
        constexpr int n_rows = 24, n_columns = 48;
        for (int i = 0; i <= n_rows; ++i) {
            const double polar = std::numbers::pi * i / n_rows;
            for (int k = 0; k < n_columns; ++k) {
                const double azimuth = 2.0 * std::numbers::pi * k / n_columns;
                const Eigen::Vector3d unit(std::sin(polar) * std::cos(azimuth),
                                           std::sin(polar) * std::sin(azimuth), std::cos(polar));
                add_to(box, ellipsoid.centre + ellipsoid.half_axes * unit);
            }
        }
        // Between the points the outline is at most 1 − cos(3.75°) = 0.2 % farther out.
        add_box(box, 0.01);
    }
    void add(const Plane& plane) {
        add_disc(plane.centre, plane.radius * plane.along,
                 plane.radius * plane.normal.cross(plane.along), std::nullopt);
    }
    void add(const Cone& cone) {
        const Eigen::Vector3d across = cone.axis.unitOrthogonal();
        const double radius = cone.length * std::tan(cone.half_angle_rad);
        add_disc(cone.apex + cone.length * cone.axis, radius * across,
                 radius * cone.axis.cross(across), cone.apex);
    }
    void add(const Mesh& mesh) {
        if (mesh.geometry == nullptr) return;
        PixelBox box;
        for (const Eigen::Vector3f& point : mesh.geometry->positions)
            add_to(box, mesh.placement * point.cast<double>());
        add_box(box, 0.0);
    }

 private:
    // Where a point is behind the eye, the whole view is taken.
    void add_to(PixelBox& box, const Eigen::Vector3d& point) const {
        if (projection_.depth(point) > projection_.near_depth) {
            box.add(projection_.place(point));
        } else {
            box.add(projection_.corner);
            box.add(projection_.corner + projection_.size);
        }
    }
    void add_box(PixelBox box, double margin_share) {
        const double margin = margin_share * std::max(box.right - box.left, box.bottom - box.top);
        box.left -= margin, box.top -= margin, box.right += margin, box.bottom += margin;
        boxes_.push_back(box.within(box_of(projection_)));
    }
    // Cut into pieces of some pixels, so that a diagonal does not take its whole rectangle.
    void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double half_px) {
        constexpr double piece_px = 16.0;
        PixelBox whole;
        add_to(whole, from);
        add_to(whole, to);
        const double length = std::hypot(whole.right - whole.left, whole.bottom - whole.top);
        const int n_pieces = std::clamp(static_cast<int>(std::ceil(length / piece_px)), 1, 512);
        for (int i = 0; i < n_pieces; ++i) {
            PixelBox box;
            add_to(box, from + (to - from) * (1.0 * i / n_pieces));
            add_to(box, from + (to - from) * (1.0 * (i + 1) / n_pieces));
            box.left -= half_px, box.top -= half_px, box.right += half_px, box.bottom += half_px;
            boxes_.push_back(box.within(box_of(projection_)));
        }
    }
    void add_disc(const Eigen::Vector3d& centre, const Eigen::Vector3d& along,
                  const Eigen::Vector3d& across, const std::optional<Eigen::Vector3d>& apex) {
        PixelBox box;
        constexpr int n_points = 96;
        for (int k = 0; k < n_points; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / n_points;
            add_to(box, centre + std::cos(angle) * along + std::sin(angle) * across);
        }
        if (apex) add_to(box, *apex);
        add_box(box, 0.01);
    }

    Projection projection_;
    std::vector<PixelBox>& boxes_;
};

PrintChoices print_of(const Record& record) {
    PrintChoices print;
    print.dpi = record.dpi;
    print.type_pt = record.type_pt;
    if (!record.journal.empty()) set_least_sizes(journal_named(record.journal), print);
    return print;
}

// The session of a record; fails for what cannot be drawn again here.
Session session_of_picture(const Record& record) {
    if (!record.sheet.empty())
        throw InputError(
            "a contact sheet has several pictures, so its record does not say where things are; "
            "ignore a rectangle instead, as --ignore 0,0,100%,10%");
    SessionRequest needs{.fonts = installed_fonts()};
    if (record.time_s) needs.times_s.push_back(*record.time_s);
    return session_of(scene_of(record, OutsideFiles::refused), needs, {});
}

}  // namespace

struct PictureRegions::Impl {
    Session session;
    FilmPlan film;
    std::optional<FilmTime> moment;  // of a still
    std::optional<PreparedPicture> picture;

    explicit Impl(const Record& record)
        : session(session_of_picture(record)), film(film_plan(session)) {
        PictureSpan span = whole_film(film);
        if (record.time_s)
            moment = record.frame ? film.moment_of(*record.frame)
                                  : still_moment(session, record.time_s, StillTime::of_scene);
        if (record.time_s && !record.film_frames) {
            span.first_time_s = std::min(film.start_s, *record.time_s);
            span.last_time_s = *record.time_s;
            span.first_shown_s = record.time_s;
        }
        span.is_still = record.time_s && record.names != fading_names;
        const PrintChoices print = print_of(record);
        if (record.page.empty())
            picture.emplace(session, span, print);
        else
            picture.emplace(session, span, vector_setting(session.scene, print));
    }

    Drawing drawing(std::optional<std::int64_t> frame) const {
        return picture->stage.at(moment ? *moment : film.moment_of(frame.value_or(0)));
    }
};

PictureRegions::PictureRegions(const Record& record)
    : impl_(std::make_unique<const Impl>(record)) {}
PictureRegions::~PictureRegions() = default;
PictureRegions::PictureRegions(PictureRegions&&) noexcept = default;
PictureRegions& PictureRegions::operator=(PictureRegions&&) noexcept = default;

std::vector<PictureRegion> PictureRegions::regions_of(std::span<const std::string> names,
                                                      int picture_width,
                                                      std::optional<std::int64_t> frame,
                                                      std::set<std::string>& found) const {
    Drawing drawing = impl_->drawing(frame);
    std::vector<PixelBox> boxes;
    const auto wants = [&](std::string_view name) {
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end()) return false;
        found.insert(*at);
        return true;
    };
    for (View& view : drawing.views) {
        // Text over all panels is in a view of its own; timed captions have no name there.
        const bool is_overlay = view.name.empty();
        BoxCollector collector(view, boxes);
        const auto add = [&](const auto& shapes) {
            // A line from a label to what it names belongs to both; the polhodes have one style.
            for (const auto& shape : shapes)
                if ((!shape.name.element.empty() && wants(shape.name.element)) ||
                    (shape.name.element == other_polhodes && wants("polhode")) ||
                    (shape.name.part == "leader" && wants(all_labels)))
                    collector.add(shape);
        };
        for_each(static_cast<SolidLists&>(view), add);
        for_each(static_cast<LineLists&>(view), add);
        for (const Label& label : view.labels) {
            const std::string_view name =
                is_overlay && label.name.element.empty() ? "caption" : label.name.element;
            const bool is_label = !is_overlay && wants(all_labels);
            if (is_label || wants(name)) collector.add(label);
        }
    }
    const double scale = 1.0 * picture_width / drawing.width_px;
    std::vector<PictureRegion> regions;
    regions.reserve(boxes.size());
    for (const PixelBox& box : boxes) {
        if (box.empty()) continue;
        constexpr int margin_px = 2;
        const auto whole = [](double px) { return static_cast<int>(std::clamp(px, -1e6, 1e6)); };
        const int left = whole(std::floor(box.left * scale)) - margin_px;
        const int top = whole(std::floor(box.top * scale)) - margin_px;
        regions.push_back({left, top, whole(std::ceil(box.right * scale)) + margin_px - left,
                           whole(std::ceil(box.bottom * scale)) + margin_px - top});
    }
    return regions;
}

std::vector<std::string_view> region_names() {
    std::vector<std::string_view> names{all_labels};
    for (const OverlayName& overlay : overlays()) names.push_back(overlay.name);
    for (const Element& element : elements()) names.push_back(element.name);
    names.insert(names.end(), {other_polhodes, separatrix});
    return names;
}

}  // namespace poinsot
