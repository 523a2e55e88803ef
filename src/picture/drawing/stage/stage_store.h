// Curves, meshes, set text and notes that panels and elements keep for all instants. Addresses stay
// valid for the store's lifetime, so that drawers and shapes can point to its contents.
#pragma once

#include <deque>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/stage/type/labels.h"
#include "shapes/lines.h"
#include "shapes/solids.h"

namespace poinsot {

struct StageContext;

class StageStore {
 public:
    // The context must outlive it.
    explicit StageStore(const StageContext& context);

    // Keeps a curve whose polyline is at most `off_px` pixels from it. All curves of a picture are
    // kept here, so that the bound in its record covers them. Throws SceneError if `off_px` is more
    // than the picture allows; `what`: a name of the curve for this message.
    const CurveGeometry* keep(CurveGeometry geometry, double off_px, std::string_view what);
    const MeshGeometry* keep(MeshGeometry geometry);

    // Sets text, and keeps its mask.
    TextBlock set(std::string_view text, const TypeStyle& style) { return text_.set(text, style); }

    // Keeps the terms of captions that have colours of their own.
    const std::vector<CaptionTerm>* keep(std::vector<CaptionTerm> terms) {
        return &terms_.emplace_back(std::move(terms));
    }

    // Adds a note about a difference between the picture and the scene, once.
    void note(std::string text);

    // Lets fades and `unlabelled` use the name of something shown; returns the kept name.
    std::string_view add_name(const std::string& name) { return *names_.insert(name).first; }

    // Arcs, circles and straight lines are these two, placed.
    const CurveGeometry* unit_circle() const { return unit_circle_; }    // about z, from x to y
    const CurveGeometry* unit_segment() const { return unit_segment_; }  // from the origin to x

    TextCache& text() { return text_; }
    const TextCache& text() const { return text_; }
    const std::deque<CurveGeometry>& curves() const { return curves_; }
    std::span<const std::string> notes() const { return notes_; }
    const std::set<std::string, std::less<>>& names() const { return names_; }
    // The largest distance of a polyline from its curve, in pixels.
    double curve_error_px() const { return curve_error_px_; }

 private:
    const StageContext* context_;
    TextCache text_;
    std::deque<CurveGeometry> curves_;
    std::deque<MeshGeometry> meshes_;
    std::deque<std::vector<CaptionTerm>> terms_;
    std::set<std::string, std::less<>> names_;
    std::vector<std::string> notes_;
    double curve_error_px_;
    const CurveGeometry* unit_circle_;
    const CurveGeometry* unit_segment_;
};

}  // namespace poinsot
