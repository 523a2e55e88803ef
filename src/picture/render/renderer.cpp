// Draws the static content, which is cached, then the moving content over it, view by view.
#include "render/renderer.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "error/error.h"
#include "render/cache/cached_curve_pass.h"
#include "render/cache/canvas.h"
#include "render/passes/arrow_pass.h"
#include "render/passes/cone_pass.h"
#include "render/passes/curve_pass.h"
#include "render/passes/ellipsoid_pass.h"
#include "render/passes/label_pass.h"
#include "render/passes/mesh_pass.h"
#include "render/passes/plane_pass.h"
#include "render/passes/screen_pass.h"
#include "render/view_scene.h"

namespace poinsot {
namespace {

// The content of the static layer; the layer is reused as long as this stays equal.
struct StillView {
    PixelBox box;
    Camera camera;
    Background background;
    std::vector<Plane> planes;
};

bool same(const StillView& a, const StillView& b) {
    return a.box == b.box && a.camera == b.camera && a.background == b.background &&
           a.planes == b.planes;
}

}  // namespace

struct Renderer::Impl {
    explicit Impl(const ContextInfo& context)
        : largest_picture_px(context.largest_picture_px),
          canvas_(context.light),
          mesh_(context.light),
          empty_(GlVertexArray::make()) {}

    void render(const Drawing& drawing, Image& image);
    void render(const Drawing& drawing, DeepImage& image);
    void render_to(const Drawing& drawing, GLuint framebuffer, ScreenAlpha alpha);

    PictureCounts counts() const;

    int largest_picture_px;

 private:
    void check_size(const Drawing& drawing) const;
    bool begin(const Drawing& drawing);
    void prepare(const Drawing& drawing);
    bool still_is_same(const Drawing& drawing);
    void draw_still(const Drawing& drawing);
    void keep_still(const Drawing& drawing);
    void draw_views(bool only_marked);
    void render_whole(const Drawing& drawing);
    void mark_labels();
    void mark_all();
    void mark_moving(const ViewScene& scene);
    void draw_moving(const ViewScene& scene, bool only_marked);
    void draw_planes(const ViewScene& scene, bool before_solids);
    void limit_to(const PixelBox& box) const;

    Canvas canvas_;
    BackgroundPass background_;
    PlanePass plane_;
    ShadowPass shadow_;
    EllipsoidPass ellipsoid_;
    CurveStore curves_;
    CurvePass curve_;
    CachedCurvePass lasting_;
    ArrowPass arrow_;
    ConePass cone_;
    LabelPass label_;
    MeshPass mesh_;
    std::optional<ScreenPass> screen_;  // made when first needed
    GlVertexArray empty_;               // for shapes whose corners are uniforms

    std::vector<ViewScene> scenes_;
    std::vector<bool> overlaps_;         // whether static content of a view covers an earlier view
    TileMask moving_, marks_;            // where something moves; what is redrawn
    std::vector<std::uint64_t> stamps_;  // as Canvas stores them
    Background still_background_;
    int still_background_top_px_ = 0;
    std::vector<StillView> still_views_;
    // Labels of the current picture, and labels that are already part of the static content.
    std::vector<PlacedLabel> labels_, still_labels_;
    bool still_is_kept_ = false;
};

void Renderer::Impl::check_size(const Drawing& drawing) const {
    const int side = std::max(drawing.width_px, drawing.height_px);
    if (drawing.width_px < 1 || drawing.height_px < 1 || side > largest_picture_px)
        throw InputError(fmt::format(
            "cannot draw a picture of {}x{} pixels; each side must be 1 to {} pixels here",
            drawing.width_px, drawing.height_px, largest_picture_px));
}

void Renderer::Impl::prepare(const Drawing& drawing) {
    const std::size_t n = drawing.views.size();
    scenes_.resize(n);
    overlaps_.assign(n, false);
    for (std::size_t k = 0; k < n; ++k) {
        scenes_[k].prepare(drawing, drawing.views[k]);
        // A view with only labels does not cover anything.
        if (drawing.views[k].background.alpha <= 0.0 && drawing.views[k].planes.empty()) continue;
        for (std::size_t j = 0; j < k; ++j)
            if (!box_of(scenes_[k].projection).within(box_of(scenes_[j].projection)).empty())
                overlaps_[k] = true;
    }
}

// Restricts drawing to a rectangle of pixels.
void Renderer::Impl::limit_to(const PixelBox& box) const {
    glEnable(GL_SCISSOR_TEST);
    glScissor(static_cast<GLint>(box.left), static_cast<GLint>(box.top),
              std::max(0, static_cast<GLsizei>(box.right - box.left)),
              std::max(0, static_cast<GLsizei>(box.bottom - box.top)));
}

void Renderer::Impl::draw_planes(const ViewScene& scene, bool before_solids) {
    for (std::size_t k = 0; k < scene.maps.size(); ++k)
        if (scene.before_solids[k] == before_solids) plane_.draw(scene, k);
}

bool Renderer::Impl::still_is_same(const Drawing& drawing) {
    std::vector<StillView> views;
    views.reserve(scenes_.size());
    for (const ViewScene& scene : scenes_) {
        StillView still{box_of(scene.projection), scene.view->camera, scene.view->background, {}};
        for (std::size_t k = 0; k < scene.maps.size(); ++k)
            if (!scene.before_solids[k]) {
                still.planes.push_back(scene.view->planes[k]);
                // Names belong to the stage, which the renderer may outlive.
                still.planes.back().name = {};
            }
        views.push_back(std::move(still));
    }
    if (drawing.background == still_background_ &&
        drawing.background_top_px == still_background_top_px_ &&
        std::equal(views.begin(), views.end(), still_views_.begin(), still_views_.end(),
                   [](const auto& a, const auto& b) { return same(a, b); }))
        return true;
    still_background_ = drawing.background;
    still_background_top_px_ = drawing.background_top_px;
    still_views_ = std::move(views);
    return false;
}

void Renderer::Impl::draw_still(const Drawing& drawing) {
    glBindVertexArray(empty_.id());
    const double top = drawing.background_top_px;
    const double rows =
        drawing.background_rows_px > 0 ? drawing.background_rows_px : drawing.height_px;
    background_.draw(drawing, drawing.background,
                     {0.0, top, static_cast<double>(drawing.width_px), top + rows});
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
        if (overlaps_[k]) continue;
        limit_to(box_of(scenes_[k].projection));
        background_.draw(*scenes_[k].drawing, scenes_[k].view->background,
                         box_of(scenes_[k].projection));
        draw_planes(scenes_[k], false);
    }
}

void Renderer::Impl::keep_still(const Drawing& drawing) {
    canvas_.begin_still();
    draw_still(drawing);
    canvas_.begin_still_on_top();
    for (const ViewScene& scene : scenes_)
        label_.draw(scene, [&](const PlacedLabel& label) {
            return std::find(still_labels_.begin(), still_labels_.end(), label) !=
                   still_labels_.end();
        });
}

void Renderer::Impl::mark_moving(const ViewScene& scene) {
    const PixelBox& box = box_of(scene.projection);
    shadow_.mark(scene, moving_);
    for (std::size_t k = 0; k < scene.maps.size(); ++k)
        if (scene.before_solids[k]) moving_.mark(disc_polygon(scene, k), box);
    for (const Quadric& q : scene.quadrics)
        if (q.seen) moving_.mark(q.outline, box);
    for (const Curve& curve : scene.view->curves)
        if (!CachedCurvePass::keeps(curve)) CurvePass::mark(scene, curve, curves_, moving_);
    lasting_.mark(scene, moving_);
    arrow_.mark(scene, moving_);
    cone_.mark(scene, moving_);
    mesh_.mark(scene, moving_);
}

// Marks the labels that differ from those in the cached static content.
void Renderer::Impl::mark_labels() {
    const auto mark_missing = [this](const auto& labels, const auto& others) {
        for (const PlacedLabel& label : labels)
            if (std::find(others.begin(), others.end(), label) == others.end())
                moving_.mark(label.box);
    };
    mark_missing(labels_, still_labels_);
    mark_missing(still_labels_, labels_);
}

// Marks everything to redraw: where something moves, and where lasting curves look different from
// the cached picture.
void Renderer::Impl::mark_all() {
    moving_.clear();
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
        if (overlaps_[k]) moving_.mark(box_of(scenes_[k].projection));
        mark_moving(scenes_[k]);
    }
    mark_labels();
    stamps_.assign(moving_.n_tiles(), 0);
    lasting_.add_stamps(stamps_);
    marks_ = moving_;
    for (std::size_t k = 0; k < stamps_.size(); ++k)
        if (stamps_[k] != canvas_.kept_stamp(k)) marks_.mark(k);
}

void Renderer::Impl::draw_moving(const ViewScene& scene, bool only_marked) {
    glBindVertexArray(empty_.id());
    for (std::size_t k = 0; k < scene.maps.size(); ++k)
        if (!scene.before_solids[k]) shadow_.draw(scene, k);
    glBindVertexArray(empty_.id());
    mesh_.draw(scene);
    ellipsoid_.draw(scene);
    for (std::size_t k = 0; k < scene.maps.size(); ++k)
        if (scene.before_solids[k]) plane_.draw(scene, k);
    cone_.draw(scene);
    arrow_.order(scene);
    arrow_.draw(scene, ArrowPass::Layer::hidden);
    for (const Curve& curve : scene.view->curves) {
        if (CachedCurvePass::keeps(curve))
            lasting_.draw(scene, curve, only_marked ? &marks_ : nullptr, curve_, curves_);
        else
            curve_.draw(scene, curve, curves_);
    }
    glBindVertexArray(empty_.id());
    arrow_.draw(scene, ArrowPass::Layer::visible);
    glDisable(GL_SCISSOR_TEST);
    label_.draw(
        scene, [&](const PlacedLabel& label) { return !only_marked || marks_.touches(label.box); });
}

void Renderer::Impl::draw_views(bool only_marked) {
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
        if (scenes_[k].mesh_layer.width > 0) {
            mesh_.draw_layer(scenes_[k]);
            canvas_.resume();
        }
        limit_to(box_of(scenes_[k].projection));
        if (overlaps_[k]) {
            glBindVertexArray(empty_.id());
            background_.draw(*scenes_[k].drawing, scenes_[k].view->background,
                             box_of(scenes_[k].projection));
            draw_planes(scenes_[k], false);
        }
        draw_moving(scenes_[k], only_marked);
    }
}

PictureCounts Renderer::Impl::counts() const {
    std::int64_t n_tiles = 0;
    for (std::size_t k = 0; k < marks_.n_tiles(); ++k) n_tiles += marks_.is_marked(k) ? 1 : 0;
    return {curves_.n_points_uploaded(), lasting_.n_segments_drawn(), n_tiles};
}

// Whether the static content is the same as in the previous picture.
bool Renderer::Impl::begin(const Drawing& drawing) {
    check_size(drawing);
    bool known = true;
    if (canvas_.resize(drawing.width_px, drawing.height_px)) {
        known = false;
        moving_.resize(drawing.width_px, drawing.height_px);
        marks_.resize(drawing.width_px, drawing.height_px);
    }
    prepare(drawing);
    known = still_is_same(drawing) && known;
    glEnable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    curves_.begin_picture();
    lasting_.begin_picture();
    label_.begin_picture(drawing);
    mesh_.begin_picture();
    for (ViewScene& scene : scenes_) {
        mesh_.prepare(scene);
        ShadowPass::prepare(scene);
        lasting_.prepare(scene, curves_);
    }
    lasting_.end_preparation();
    return known;
}

void Renderer::Impl::render_whole(const Drawing& drawing) {
    still_is_kept_ = false;
    marks_.fill();
    canvas_.begin_whole();
    draw_still(drawing);
    draw_views(false);
}

void Renderer::Impl::render_to(const Drawing& drawing, GLuint framebuffer, ScreenAlpha alpha) {
    begin(drawing);
    render_whole(drawing);
    glBindVertexArray(empty_.id());
    if (!screen_) screen_.emplace();
    // The alpha of an opaque picture is rounded.
    if (drawing.background.alpha >= 1.0) alpha = ScreenAlpha::opaque;
    screen_->draw(canvas_.light(), drawing.width_px, drawing.height_px, framebuffer, alpha);
}

void Renderer::Impl::render(const Drawing& drawing, DeepImage& image) {
    begin(drawing);
    render_whole(drawing);
    canvas_.read_whole(image, drawing.background.alpha < 1.0);
}

void Renderer::Impl::render(const Drawing& drawing, Image& image) {
    const bool known = begin(drawing);
    const bool transparent = drawing.background.alpha < 1.0;
    const std::vector<PlacedLabel> labels_before =
        std::exchange(labels_, LabelPass::placed(drawing));

    // Static content that was the same in the previous picture will probably stay the same: cache
    // it.
    if (!known) {
        render_whole(drawing);
        canvas_.read_whole(image, transparent);
        return;
    }
    if (!still_is_kept_) {
        std::erase_if(still_labels_ = labels_, [&](const PlacedLabel& label) {
            return std::find(labels_before.begin(), labels_before.end(), label) ==
                   labels_before.end();
        });
        keep_still(drawing);
        canvas_.keep_still(transparent, marks_.n_tiles());
        still_is_kept_ = true;
    }
    mark_all();
    canvas_.begin_over_still(marks_);
    draw_views(true);
    canvas_.read_over_still(marks_, image, transparent);
    for (std::size_t k = 0; k < stamps_.size(); ++k)
        if (marks_.is_marked(k) && !moving_.is_marked(k))
            canvas_.keep_tile(marks_, k, stamps_[k], image);
}

Renderer::Renderer(const ContextInfo& context) : impl_(std::make_unique<Impl>(context)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::render(const Drawing& drawing) {
    Image image;
    impl_->render(drawing, image);
    return image;
}

PictureCounts Renderer::counts() const { return impl_->counts(); }

void Renderer::render_into(const Drawing& drawing, Image& image) { impl_->render(drawing, image); }

void Renderer::render_into(const Drawing& drawing, DeepImage& image) {
    impl_->render(drawing, image);
}

void Renderer::render_to(const Drawing& drawing, unsigned framebuffer, ScreenAlpha alpha) {
    impl_->render_to(drawing, framebuffer, alpha);
}

}  // namespace poinsot
