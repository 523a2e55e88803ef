#include "drawing/figures/panels/idle_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "drawing/figures/panels/panels.h"
#include "drawing/stage/overlay.h"

namespace poinsot {

namespace {

bool shows_element(const Scene& scene, std::string_view name) {
    return scene.show.empty() ||
           std::find(scene.show.begin(), scene.show.end(), name) != scene.show.end();
}

// Keys of [camera] that the scene gives and that none of its panels uses.
std::vector<std::string> idle_camera_keys(const Scene& scene) {
    // The part of [camera] that the panels without a direction of their own use.
    CameraUse use = CameraUse::none;
    bool any_view = scene.panels.empty();
    for (const PanelSpec& spec : scene.panels) {
        const auto kind =
            std::find_if(std::begin(panel_rows), std::end(panel_rows),
                         [&spec](const PanelKind& row) { return row.name == spec.kind; });
        if (kind == std::end(panel_rows)) return {};
        // The plan is flat, but follows the azimuth of the space panel's camera.
        if (kind->name == "plan") return {};
        any_view = any_view || kind->camera != CameraUse::none;
        if (kind->own_direction == nullptr) use = std::max(use, kind->camera);
    }
    if (scene.panels.empty()) {
        const bool keeps_L = std::holds_alternative<NoTorque>(scene.torque) ||
                             std::holds_alternative<DissipationTorque>(scene.torque);
        use = keeps_L && scene.construction.sweep.empty() ? CameraUse::all : CameraUse::direction;
    }
    std::vector<std::string> idle;
    const auto add = [&](std::string_view leaf) {
        std::string path = fmt::format("camera.{}", leaf);
        if (scene.locations.contains(path)) idle.push_back(std::move(path));
    };
    if (!any_view)
        for (const char* leaf : {"field_deg", "projection"}) add(leaf);
    if (use < CameraUse::direction)
        for (const char* leaf : {"azimuth_deg", "elevation_deg", "view"}) add(leaf);
    if (use < CameraUse::all)
        for (const char* leaf : {"distance", "target", "look_at"}) add(leaf);
    return idle;
}

class UnusedKeys {
 public:
    explicit UnusedKeys(const Scene& scene) : scene_(scene) {
        const bool keeps_L = std::holds_alternative<NoTorque>(scene.torque) ||
                             std::holds_alternative<DissipationTorque>(scene.torque);
        dissipates_ = std::holds_alternative<DissipationTorque>(scene.torque);
        if (!scene.panels.empty()) return;
        alone_ = !scene.construction.sweep.empty() ? "sweep" : keeps_L ? "space" : "object";
    }

    std::vector<IdleKey> made() && {
        for (std::string& key : idle_camera_keys(scene_))
            idle_.push_back({std::move(key),
                             "no panel here uses this key of [camera]; set it in [panels.camera] "
                             "of a panel, or leave it out"});
        add_trails();
        add_elements();
        add_panels();
        add_marks();
        return std::move(idle_);
    }

 private:
    bool any(std::initializer_list<std::string_view> kinds) const {
        const auto is_one = [&kinds](std::string_view kind) {
            return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
        };
        return scene_.panels.empty()
                   ? is_one(alone_)
                   : std::any_of(scene_.panels.begin(), scene_.panels.end(),
                                 [&is_one](const PanelSpec& panel) { return is_one(panel.kind); });
    }

    void add(std::string key, std::string why) {
        if (scene_.locations.contains(key)) idle_.push_back({std::move(key), std::move(why)});
    }

    void add_trails() {
        const bool polhode = (any({"space"}) && shows_element(scene_, "polhode")) ||
                             (dissipates_ && any({"body", "momentum"}));
        const bool herpolhode =
            (any({"space"}) && shows_element(scene_, "herpolhode")) || any({"plan"});
        if (!polhode) add("trail.polhode", "no panel here draws the polhode as a trail");
        if (!herpolhode) add("trail.herpolhode", "no panel here shows the herpolhode");
        const bool fades = scene_.trail.polhode == "fading" || scene_.trail.herpolhode == "fading";
        if (!fades)
            add("trail.length_s",
                "no trail is \"fading\"; set trail.polhode or trail.herpolhode to it, or leave "
                "this key out");
        if (!any({"space", "plan"}))
            add("trail.direction_marks", "only panels \"space\" and \"plan\" show direction marks");
    }

    void add_elements() {
        for (const std::string& name : scene_.show) {
            if (any({"space"}) || is_overlay(name)) continue;
            add("show", fmt::format("\"{}\" is an element of panel \"space\"; add such a panel, or "
                                    "leave the element out",
                                    name));
            break;
        }
        const bool body = any({"object", "sweep"}) ||
                          (any({"space"}) && !scene_.show.empty() && shows_element(scene_, "body"));
        for (const char* key : {"object.name", "object.mesh"})
            if (!body)
                add(key,
                    "no panel here shows the body itself; add a panel \"object\", or leave "
                    "it out");
    }

    void add_panels() {
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            const std::string& kind = scene_.panels[i].kind;
            const auto only_of = [&](std::string_view key, std::string_view owner) {
                if (kind != owner)
                    add(fmt::format("panels[{}].{}", i, key),
                        fmt::format("only panel \"{}\" uses it, and this panel is \"{}\"", owner,
                                    kind));
            };
            only_of("quantity", "plot");
            only_of("curves", "body");
            if (scene_.panels.size() == 1 && !scene_.panels[0].title.value_or("").empty())
                add("panels[0].title", "a single panel shows no heading; give the scene a title");
        }
        // A keyframe of all cameras whose distance or aim no panel uses.
        const bool aimed = std::any_of(
            scene_.panels.begin(), scene_.panels.end(),
            [](const PanelSpec& panel) { return panel.kind == "space" || panel.kind == "plan"; });
        if (aimed || alone_ == "space") return;
        for (std::size_t i = 0; i < scene_.keyframes.size(); ++i)
            for (const char* leaf : {"distance", "target", "look_at"})
                if (!scene_.keyframes[i].panel)
                    add(fmt::format("keyframes[{}].{}", i, leaf),
                        "every panel here fits all of its content into its frame; only panel "
                        "\"space\" uses it");
    }

    void add_marks() {
        const bool body_inside =
            any({"space"}) && !scene_.show.empty() && shows_element(scene_, "body");
        for (std::size_t i = 0; i < scene_.marks.size(); ++i) {
            const std::string key = fmt::format("marks[{}]", i);
            const std::string& on = scene_.marks[i].on;
            if (on == "ellipsoid" && !any({"space", "body"}))
                add(key, "no panel here shows the ellipsoid; add a panel \"space\" or \"body\"");
            if (on == "space" && !any({"space"}))
                add(key, "only panel \"space\" shows marks in space; add such a panel");
            if (on == "body" && !any({"object"}) && !body_inside)
                add(key, "no panel here shows the body itself; add a panel \"object\"");
            if (scene_.marks[i].trail && (on == "space" || !any({"space", "object"})))
                add(key + ".trail", "this mark does not move in the panels here");
        }
    }

    const Scene& scene_;
    bool dissipates_ = false;
    std::string_view alone_;  // kind of the only panel of a scene that lists none
    std::vector<IdleKey> idle_;
};

}  // namespace

std::vector<IdleKey> idle_keys(const Scene& scene) { return UnusedKeys(scene).made(); }

}  // namespace poinsot
