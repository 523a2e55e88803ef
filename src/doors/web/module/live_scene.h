// A scene as a page shows it: the session and the stage of a canvas, with cameras that viewers
// turn. It makes drawings and numbers; it knows neither OpenGL nor the browser.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stage/stage.h"
#include "production/session/session.h"

namespace poinsot {

// A scene's text, its name for messages, overrides as those of --set, and the files that it names.
struct PageScene {
    std::string_view text;
    std::string name;
    std::span<const std::string> overrides;
    const std::map<std::string, std::string>& files;
};

// How a viewer changed the view of a panel. NaN: not changed.
struct PanelView {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();
    int panel = 0;
    double azimuth_deg = none, elevation_deg = none;  // of the eye, seen from the target
    double roll_deg = none;                           // clockwise, of the picture
    double distance = none;                           // of the eye, view units
    double zoom = none;                               // factor on the size of what is seen
    // Of the picture, to the right and up, in heights of the panel.
    double shift_x = none, shift_y = none;
};

// The values of a view by the names that pages and their scripts give them, in the order in which
// they follow the number of the panel.
struct ViewField {
    std::string_view name;
    double PanelView::*value;
};
inline constexpr std::array<ViewField, 7> view_fields{{{"azimuth_deg", &PanelView::azimuth_deg},
                                                       {"elevation_deg", &PanelView::elevation_deg},
                                                       {"roll_deg", &PanelView::roll_deg},
                                                       {"distance", &PanelView::distance},
                                                       {"zoom", &PanelView::zoom},
                                                       {"shift_x", &PanelView::shift_x},
                                                       {"shift_y", &PanelView::shift_y}}};
inline constexpr std::size_t n_view_numbers = 1 + view_fields.size();

// Of the canvas. `type_scale`: factor on the size of all type, for small screens.
struct CanvasSize {
    int width_px = 0, height_px = 0;
    double type_scale = 1.0;
};

// From n_view_numbers numbers.
PanelView panel_view(std::span<const double> numbers);

// The camera of a panel after a viewer's changes.
Camera changed(const Camera& camera, const PanelView& view);

class LiveScene {
 public:
    // Throws InputError.
    LiveScene(const PageScene& files, FontSource fonts, const CanvasSize& size);
    LiveScene(const LiveScene&) = delete;
    LiveScene& operator=(const LiveScene&) = delete;

    // Lays out anew for a canvas of this size.
    void resize(const CanvasSize& size);
    void set_views(const std::vector<PanelView>& views);
    // The cameras of the panels at an instant, and whether they stay as they were at one: while a
    // value is dragged, the figure is not framed anew. Empty: they do not.
    std::vector<Camera> cameras_at(const FilmTime& moment) const;
    void hold(const std::vector<Camera>& cameras);

    // `film_s`: second of the film; NaN: the first that shows the instant.
    FilmTime moment_of(double time_s, double film_s = PanelView::none) const;
    double time_at(double film_s) const { return film_.clock.time_at(film_s); }

    // The body beside the construction is shown this many seconds of the motion later: it turns
    // while everything else stands.
    Drawing drawing_at(const FilmTime& moment, double beside_later_s = 0.0) const;
    // The same for a picture of another size. The drawing is valid until the next call.
    Drawing drawing_of_size(const FilmTime& moment, int width_px, int height_px);

    // The digits of `poinsot sample`: ω in body axes, the attitude as w, x, y, z, the component of
    // ω perpendicular to L in space axes and, of a heavy top, θ, φ and ψ.
    std::vector<double> digits_at(double time_s) const;

    // The state as one sentence, in the scene's language.
    std::string state_at(const FilmTime& moment) const;

    // The instant as an SVG file, with all type as paths.
    std::string svg_at(const FilmTime& moment) const;

    // What can be dragged, and where on the canvas, as a list in JSON: {"panel": 0, "thing":
    // "omega", "x": 412.5, "y": 300.25, "moved_x": 398.0, "moved_y": 287.5} at the tips of ω and
    // of ρ, which both move the tip of ρ; "plane" where L meets the invariable plane.
    std::string grips_at(const FilmTime& moment) const;

    // The ω in body axes, with the energy of the instant, with which the tip of ρ is seen at a
    // pixel of the canvas, or as near to it as it can be. L keeps its direction in space, and the
    // body of a panel in space turns with that as little as it needs. Empty where the panel has no
    // inertia ellipsoid.
    std::optional<Eigen::Vector3d> omega_under(const FilmTime& moment, int panel,
                                               const Eigen::Vector2d& px) const;

    // The start, at t = 0, of the free motion whose ω at this instant is this one, and whose L has
    // the direction that it has now; the body is turned as little as that needs. Empty where the
    // motion is not free, or its ω is chosen by conserved quantities.
    std::optional<RotationState> start_with(const FilmTime& moment,
                                            const std::optional<Eigen::Vector3d>& omega) const;

    // The kinetic energy with which the invariable plane, moved along L at constant |L|, meets L
    // as near as possible to a pixel of the canvas; within the energies that this |L| allows.
    // Empty where the panel has no such plane.
    std::optional<double> energy_of_plane_at(const FilmTime& moment, int panel,
                                             const Eigen::Vector2d& px) const;
    // The ω with that energy and the |L| of the instant, nearest to its ω.
    std::optional<Eigen::Vector3d> omega_of_plane_at(const FilmTime& moment, int panel,
                                                     const Eigen::Vector2d& px) const;

    // The scene, its film and its panels, as JSON.
    std::string description() const;
    std::string panels_text() const;

 private:
    bool has_panel(int panel) const;
    // Sizes the scene's pictures. On upright ones the panels stand one below the other.
    void size_scene(const CanvasSize& size);
    Stage stage_of_size(const CanvasSize& size);

    CanvasSize film_size_;  // of the scene as read
    Session session_;
    GridSpec grid_;                  // of the scene as read
    std::vector<PanelSpec> panels_;  // likewise
    double type_scale_;              // of the scene
    CanvasSize size_;
    FilmPlan film_;
    std::optional<Stage> stage_, picture_stage_;
    std::vector<CameraChange> cameras_;  // by panel
    std::vector<CameraChange> held_;     // likewise, in their place; empty: not held
};

}  // namespace poinsot
