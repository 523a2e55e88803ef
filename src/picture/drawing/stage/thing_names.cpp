#include "drawing/stage/thing_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "drawing/stage/label_requests.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/type/name_places.h"
#include "drawing/style/theme_roles.h"
#include "numerics/smooth_step.h"
#include "scene/scene.h"
#include "scene/scene_error.h"

namespace poinsot {

namespace {

// Whether a title of the scene or of one of its chapters contains the words.
bool is_spoken_of(const Scene& scene, std::string_view words) {
    const auto lower = [](std::string_view text) {
        std::string made(text);
        for (char& c : made)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        return made;
    };
    const std::string name = lower(words);
    const auto has = [&](const std::string& title) {
        return lower(title).find(name) != std::string::npos;
    };
    return !name.empty() &&
           (has(scene.title) ||
            std::any_of(scene.chapters.begin(), scene.chapters.end(),
                        [&](const ChapterSpec& chapter) { return has(chapter.title); }));
}

// The place of a name and its opacity.
struct ShownName {
    std::optional<PlacedName> placed;
    double opacity = 0.0;
};

// The places that are planned for a second of the film: two while the name changes its side. What
// crosses the name between the instants of the plan makes it fade.
std::vector<ShownName> planned_places(const Spots& spots, const ThingName& name,
                                      const Surroundings& around, double film_s) {
    std::vector<ShownName> found;
    for (const NameSpan& span : *name.spans) {
        ShownName shown{{}, span.presence(film_s)};
        if (!(shown.opacity > 0.0)) continue;
        shown.placed = placed_at(spots, name, span.side, around);
        if (!shown.placed) continue;
        shown.opacity *= 1.0 - covered_share(shown.placed->spot.box, around, name.em_px);
        found.push_back(shown);
    }
    // Where its two places overlap, the name fades at one and then appears at the other.
    if (found.size() == 2 && found[0].placed->spot.box.distance(found[1].placed->spot.box) <= 0.0)
        for (ShownName& shown : found) shown.opacity = std::max(0.0, 2.0 * shown.opacity - 1.0);
    return found;
}

// Adds a name's label to the view, and its leader.
void add_name(const Panel& panel, const ThingName& name, const Spots& spots, const Spot& spot,
              double opacity, View& view) {
    Label label;
    label.mask = name.type.mask;
    label.top_left_px = spot.box.centre_px - spot.box.half_px + name.offset_px;
    label.colour = name.colour;
    label.halo_colour = panel.stage->theme.halo;
    label.halo_px = 4.0 * panel.px;
    label.opacity = opacity;
    label.rank = rank_of_things;
    label.at = spot.at;
    label.name = {name.thing->name, 0, ""};
    view.labels.push_back(label);
    const LabelBox box = label_box(label);
    if (!spots.has_leader()) return;
    // A name that was moved by hand may be nearer to another point of its thing.
    const VisiblePoint* const nearest = name.offset_px.isZero() ? nullptr : spots.nearest(box);
    const Leader leader{.at = nearest != nullptr ? nearest->at : spot.at,
                        .from_px = nearest != nullptr ? nearest->px : spot.anchor_px,
                        .to = box,
                        .colour = name.colour,
                        .width_px = 1.6 * panel.px,
                        .name = {name.thing->name, 0, "leader"}};
    const double drawn = leader_share(box.distance(leader.from_px), name.em_px);
    const bool is_still = panel.stage->options.is_still;
    add_leader(leader, label.opacity * (is_still ? whole_or_absent(drawn) : drawn),
               panel.unit_segment, view);
}

}  // namespace

double name_margin_px(const Panel& panel) {
    return std::max(3.0 * px_per_pt(*panel.stage), 6.0 * panel.px);
}

std::vector<ThingName> set_thing_names(const Panel& panel, StageStore& store) {
    const StageContext& stage = *panel.stage;
    const Scene& scene = stage.scene;
    const auto is_in = [](const std::vector<std::string>& list, std::string_view name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    std::vector<ThingName> names;
    if ((panel_kind_named(panel.spec.kind).uses & uses_names) == 0) return names;
    if (!scene.labels || is_in(scene.unlabelled, panel.spec.kind)) return names;
    for (const NamedThing& thing : things_with_names()) {
        if (scene.names && !is_in(*scene.names, thing.name)) continue;
        if (is_in(scene.unlabelled, thing.element)) continue;
        const auto own = scene.symbols.things.find(thing.name);
        const std::string key = fmt::format("symbols.{}", thing.name);
        const std::string text = own != scene.symbols.things.end()
                                     ? own->second
                                     : std::string(words_of_plane(scene, thing.name, thing.words));
        if (text.empty()) continue;
        const TypeStyle style{
            .size_px = std::max(type_sizes(stage).thing_name * panel.type_px, least_type_px(stage)),
            .mode = TypeMode::text};
        const Colour colour = line_of(stage.theme, thing.role);
        names.push_back({.thing = &thing,
                         .type = at_scene_key(scene, key, [&] { return store.set(text, style); }),
                         .colour = colour,
                         .em_px = style.size_px,
                         .offset_px = offset_of_label(stage, thing.name)});
    }
    // Things that the scene's titles mention come first.
    std::stable_partition(names.begin(), names.end(), [&](const ThingName& name) {
        return is_spoken_of(scene, name.type.mask->source.text);
    });
    return names;
}

std::vector<UnnamedThing> place_thing_names(const Panel& panel, const std::vector<ThingName>& names,
                                            const std::vector<LabelBox>& overlays, double film_s,
                                            bool is_planned, View& view) {
    std::vector<UnnamedThing> left_out;
    const bool is_still = panel.stage->options.is_still;
    // Nobody misses a name that no scene can ask for.
    const auto leave_out = [&left_out](const ThingName& name, bool is_in_sight) {
        const std::string_view of = name.thing->name;
        if (std::find(named_things.begin(), named_things.end(), of) != named_things.end())
            left_out.push_back({of, is_in_sight});
    };
    std::optional<Surroundings> around;  // made for the first name that the view shows
    for (const ThingName& name : names) {
        if (name.type.mask->width == 0) continue;
        const Spots spots(view, name);
        const double share = seen_share(spots);
        if (spots.is_shown() && share < 0.5) leave_out(name, false);
        const bool has_plan = name.spans && is_planned;
        // The plan fades the name; what has nearly vanished has none between its instants.
        const double seen = has_plan   ? smooth_step(10.0 * spots.opacity() - 1.5)
                            : is_still ? whole_or_absent(share)
                                       : share;
        if (!(seen > 0.0)) continue;
        if (!around) around = surroundings_of(view, overlays, name_margin_px(panel));
        std::vector<ShownName> places;
        if (has_plan) {
            places = planned_places(spots, name, *around, film_s);
        } else if (std::optional<PlacedName> best = best_place(spots, name, *around)) {
            places.push_back({best, best->has_room ? 1.0 : 0.0});
        }
        double whole = 0.0;
        for (ShownName& shown : places) {
            if (is_still) shown.opacity = whole_or_absent(shown.opacity);
            whole = std::max(whole, shown.opacity);
        }
        if (whole < 0.5) leave_out(name, true);
        for (const ShownName& shown : places)
            if (shown.opacity > 0.0)
                add_name(panel, name, spots, shown.placed->spot, shown.opacity * seen, view);
        for (const ShownName& shown : places)
            if (shown.opacity > 0.0)
                around->labels.push_back({shown.placed->spot.box.centre_px + name.offset_px,
                                          shown.placed->spot.box.half_px, shown.opacity * seen});
    }
    return left_out;
}

}  // namespace poinsot
