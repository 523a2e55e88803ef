#include "drawing/figures/panels/idle_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "drawing/figures/elements/elements.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "text/nearest.h"
#include "text/units.h"

namespace poinsot {

namespace {

bool shows_element(const Scene& scene, std::string_view name) {
    return scene.show.empty() ||
           std::find(scene.show.begin(), scene.show.end(), name) != scene.show.end();
}

class UnusedKeys {
 public:
    explicit UnusedKeys(const Scene& scene) : scene_(scene), dissipates_(dissipates(scene.torque)) {
        // Without a motion a heavy top is not known. "object", the panel of other falling bodies,
        // uses every key that "top" uses, except trail.axis.
        if (scene.panels.empty()) kinds_ = {&panel_kind_named(default_panel(scene, false))};
        for (const PanelSpec& spec : scene.panels)
            if (const PanelKind* kind = find_row(panel_kinds(), spec.kind)) kinds_.push_back(kind);
    }

    std::vector<IdleKey> made() && {
        // The stage refuses a panel that does not exist.
        if (kinds_.size() < scene_.panels.size()) return {};
        add_camera();
        add_names();
        add_measured();
        add_trails();
        add_elements();
        add_panels();
        add_marks();
        add_units();
        return std::move(idle_);
    }

 private:
    template <typename Predicate>
    bool any_kind(Predicate holds) const {
        return std::any_of(kinds_.begin(), kinds_.end(),
                           [&holds](const PanelKind* kind) { return holds(*kind); });
    }
    bool any(PanelUses key) const {
        return any_kind([key](const PanelKind& kind) { return (kind.uses & key) != 0; });
    }

    bool has_inset() const {
        return any(uses_inset) &&
               std::any_of(scene_.panels.begin(), scene_.panels.end(),
                           [](const PanelSpec& panel) { return !panel.inset.empty(); });
    }

    void add(std::string key, std::string why) {
        if (scene_.locations.contains(key)) idle_.push_back({std::move(key), std::move(why)});
    }

    void add_camera() {
        if (any(uses_azimuth)) return;
        const bool any_view =
            any_kind([](const PanelKind& kind) { return kind.camera != CameraUse::none; });
        // The part of [camera] that the panels without a direction of their own use.
        CameraUse use = CameraUse::none;
        for (const PanelKind* kind : kinds_)
            if (kind->default_view_direction == nullptr) use = std::max(use, kind->camera);
        const auto add_leaves = [this](std::initializer_list<std::string_view> leaves) {
            for (const std::string_view leaf : leaves)
                add(fmt::format("camera.{}", leaf),
                    "no panel here uses this key of [camera]; set it in [panels.camera] of a "
                    "panel, or leave it out");
        };
        if (!any_view) add_leaves({"field_deg", "projection"});
        if (use < CameraUse::direction)
            add_leaves({"azimuth_deg", "elevation_deg", "roll_deg", "view"});
        if (use < CameraUse::all) add_leaves({"distance", "target", "look_at"});
    }

    void add_names() {
        if (!any(uses_names))
            add("names", fmt::format("only panels {} name curves and surfaces",
                                     panels_that_use(uses_names, "and")));
    }

    void add_measured() {
        if (!any(uses_measured))
            add("measured.file", fmt::format("only panels {} show a measured motion",
                                             panels_that_use(uses_measured, "and")));
    }

    void add_trails() {
        const bool polhode = (any(uses_elements) && shows_element(scene_, "polhode")) ||
                             (dissipates_ && any(uses_polhode_trail));
        const bool herpolhode = (any(uses_elements) && shows_element(scene_, "herpolhode")) ||
                                any(uses_herpolhode) || has_inset();
        if (!polhode) add("trail.polhode", "no panel here draws the polhode as a trail");
        const bool axis =
            any(uses_axis_path) || (scene_.panels.empty() && has_weight(scene_.torque));
        if (!herpolhode)
            add("trail.herpolhode",
                axis
                    ? "no panel here shows the herpolhode; the path of the top's axis is trail.axis"
                    : "no panel here shows the herpolhode");
        if (!axis) add("trail.axis", "only panel \"top\" shows the path of a top's axis");
        const TrailSpec& trail = scene_.trail;
        const bool fades =
            trail.polhode == "fading" || trail.herpolhode == "fading" || trail.axis == "fading";
        if (!fades)
            add("trail.length_s",
                "no trail is \"fading\"; set trail.polhode, trail.herpolhode or trail.axis to "
                "it, or leave this key out");
        if (!any(uses_direction_marks))
            add("trail.direction_marks", fmt::format("only panels {} show direction marks",
                                                     panels_that_use(uses_direction_marks, "and")));
        if (!any(uses_elements))
            add("trail.ticks", "only panel \"space\" shows two curves that roll on each other");
    }

    void add_elements() {
        for (const std::string& name : scene_.show) {
            if (is_overlay(name)) continue;
            const Element* element = find_row(elements(), name);
            // The stage refuses an unknown name.
            const PanelUses panels = element != nullptr ? element->shown_in : uses_elements;
            if (any(panels)) continue;
            add("show",
                fmt::format("\"{}\" is an element of panel {}; add such a panel, or leave the "
                            "element out",
                            name, panels_that_use(panels, "or")));
            break;
        }
        if (!any(uses_elements) && !any(uses_forces) && !any(uses_solid_angle))
            add("page.elements",
                "no panel here shows elements; add a panel \"space\", or leave it out");
        const bool body = any(uses_object) || (any(uses_elements) && !scene_.show.empty() &&
                                               shows_element(scene_, "body"));
        for (const char* key : {"object.name", "object.mesh"})
            if (!body)
                add(key,
                    "no panel here shows the body itself; add a panel \"object\", or leave "
                    "it out");
    }

    void add_panels() {
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            const auto only_of = [&](std::string_view leaf, PanelUses key) {
                if ((kinds_[i]->uses & key) == 0)
                    add(fmt::format("panels[{}].{}", i, leaf),
                        fmt::format("only panel {} uses it, and this panel is \"{}\"",
                                    panels_that_use(key, "and"), kinds_[i]->name));
            };
            only_of("quantity", uses_quantity);
            only_of("curves", uses_curves);
            only_of("inset", uses_inset);
            if (scene_.panels.size() == 1 && !scene_.panels[0].title.value_or("").empty())
                add("panels[0].title", "a single panel shows no heading; give the scene a title");
        }
        // A keyframe of all cameras whose distance or aim no panel uses.
        const auto aims = [](const PanelKind& kind) { return kind.camera == CameraUse::all; };
        if (any_kind(aims) || any(uses_azimuth)) return;
        for (std::size_t i = 0; i < scene_.keyframes.size(); ++i)
            for (const char* leaf : {"distance", "target", "look_at"})
                if (!scene_.keyframes[i].panel)
                    add(fmt::format("keyframes[{}].{}", i, leaf),
                        fmt::format("every panel here fits all of its content into its frame; only "
                                    "panel {} uses it",
                                    panels_where(aims, "and")));
    }

    void add_marks() {
        const bool body_inside =
            any(uses_elements) && !scene_.show.empty() && shows_element(scene_, "body");
        for (std::size_t i = 0; i < scene_.marks.size(); ++i) {
            const std::string key = fmt::format("marks[{}]", i);
            const std::string& on = scene_.marks[i].on;
            if (on == "ellipsoid" && !any(uses_marks_on_ellipsoid))
                add(key, "no panel here shows the ellipsoid; add a panel \"space\" or \"body\"");
            if (on == "space" && !any(uses_marks_in_space))
                add(key, "only panel \"space\" shows marks in space; add such a panel");
            if (on == "body" && !any(uses_marks_on_body) && !body_inside)
                add(key, "no panel here shows the body itself; add a panel \"object\"");
            if (scene_.marks[i].trail && (on == "space" || !any(uses_mark_trails)))
                add(key + ".trail", "this mark does not move in the panels here");
        }
    }

    void add_units() {
        // Of live numbers and charts.
        constexpr std::array<std::string_view, 5> shown{"s", "rad", "rad/s", "J", "kg m²/s"};
        for (const std::string& name : scene_.units) {
            const auto measures = [unit = unit_named(name)](std::string_view quantity) {
                return unit->dimension == unit_named(quantity)->dimension;
            };
            if (std::none_of(shown.begin(), shown.end(), measures))
                add("units",
                    fmt::format("\"{}\" is a unit of none of the numbers shown, which are times, "
                                "angles, rates of rotation (rad/s, deg/s, rpm), energies (J) and "
                                "angular momenta (kg m²/s)",
                                name));
        }
    }

    const Scene& scene_;
    bool dissipates_;
    std::vector<const PanelKind*> kinds_;  // of the scene's panels, or the default one
    std::vector<IdleKey> idle_;
};

}  // namespace

std::vector<IdleKey> idle_keys(const Scene& scene) { return UnusedKeys(scene).made(); }

}  // namespace poinsot
