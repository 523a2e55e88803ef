#include "drawing/figures/panels/scene_names.h"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "drawing/figures/charts/plot_quantity.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/layout.h"
#include "drawing/stage/overlay.h"
#include "drawing/stage/panel_kind.h"
#include "drawing/stage/stage_context.h"
#include "scene/scene_error.h"

namespace poinsot {

void check_scene_names(const Scene& scene, const Theme& theme, const Motion& motion) {
    const StageOptions at_start;
    const StageContext stage(scene, theme, motion, at_start, nullptr);
    check_element_names(scene);
    // Names of things that the picture may show. The stage alone knows which marks and measured
    // points it has.
    std::set<std::string, std::less<>> names{"marks", "measured"};
    const std::vector<PanelSpec> panels = panels_of(stage);
    const std::vector<const PanelKind*> kinds = kinds_of(scene, panels);
    unsigned used = uses_nothing;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const PanelKind& kind = *kinds[i];
        check_possible(stage, kind);
        names.emplace(kind.name);
        used |= kind.uses;
        if ((kind.uses & uses_quantity) == 0 || panels[i].quantity.empty()) continue;
        at_scene_key(scene, fmt::format("panels[{}].quantity", i),
                     [&] { plot_quantity_of(stage, panels[i].quantity); });
    }
    for (const Element& element : elements())
        if ((used & element.shown_in) != 0 && (scene.show.empty() || is_shown(stage, element.name)))
            names.emplace(element.name);
    for (const OverlayName& overlay : overlays())
        if (is_overlay_shown(scene, overlay.name)) names.emplace(overlay.name);
    check_named_elements(scene, names);
}

}  // namespace poinsot
