#include "production/stills/picture_regions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/overlay.h"
#include "error/error.h"
#include "production/session/film_plan.h"
#include "production/session/picture_setting.h"
#include "production/session/still_moment.h"
#include "production/stills/recorded_still.h"
#include "production/vectors/vector_still.h"
#include "shapes/shape_boxes.h"

namespace poinsot {

namespace {

constexpr std::string_view all_labels = "labels";
// The curves of panel body beside that of the motion.
constexpr std::string_view other_polhodes = "polhodes", separatrix = "separatrix";

// The session of a record; fails for what cannot be drawn again here.
Session session_of_picture(const Record& record) {
    if (!record.sheet.empty())
        throw InputError(
            "a contact sheet has several pictures, so its record does not say where things are; "
            "ignore a rectangle instead, as --ignore 0,0,100%,10%");
    return session_of(scene_of(record, OutsideFiles::refused), needs_of(record), {});
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
        if (record.time_s && !record.film_frames)
            span = span_of_instant(session, film, *record.time_s);
        const StillRequest still = request_of(record);
        span.is_still = record.time_s && !still.names_fade;
        const PrintChoices& print = still.print;
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
        ShapeBoxes collector(view, boxes);
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
