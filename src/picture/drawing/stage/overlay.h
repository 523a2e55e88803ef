// Text over the whole picture: the scene's title and caption, and the clock.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/panel.h"

namespace poinsot {

// Drawers of the overlays that the scene lists; by default, all for which it has text.
std::vector<Drawer> make_overlays(const StageContext& stage, StageStore& store,
                                  const std::deque<Panel>& panels);

// `text`: sets the overlays.
OverlayBands overlay_bands(const StageContext& stage, TextCache& text);

// Rows that the overlays of a picture with this width need beyond those on a screen. `px`: width of
// a line of "one pixel at 1080 rows". Text whose size is given in points takes more rows of a
// narrow page.
int rows_added_by_type(const Scene& scene, const FontSource& fonts, int width_px, double px,
                       const LeastSizes& least);

// Rows that the overlays of such a picture take in total.
int rows_of_overlays(const Scene& scene, const FontSource& fonts, int width_px, double px,
                     const LeastSizes& least);

// Names the units in the scene's captions that do not belong to the number beside them, with their
// places. Throws SceneError for an invalid caption.
std::vector<std::string> caption_notes(const Scene& scene);

// Distance between the overlays and the picture's sides.
double overlay_margin_px(const StageContext& stage);

// The seconds in which a text that is shown in this part of a film fades in, and out.
double text_fade_s(double begin_s, double end_s);

// Names of the overlays in `show` and in fades.
struct OverlayName {
    std::string_view name;
    std::string_view summary;
};
std::span<const OverlayName> overlays();

// Whether a name in `show` is an overlay.
bool is_overlay(std::string_view name);

// Whether the scene shows this overlay.
bool is_overlay_shown(const Scene& scene, std::string_view name);

}  // namespace poinsot
