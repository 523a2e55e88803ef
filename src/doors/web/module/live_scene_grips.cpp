// What can be dragged in a figure, and the motions that follow from a drag.
#include <algorithm>
#include <cmath>

#include "drawing/stage/panel.h"
#include "mechanics/free/polhode_start.h"
#include "shapes/projection.h"
#include "text/json_text.h"
#include "web/module/live_scene.h"

namespace poinsot {

namespace {

// The ellipsoid of inertia of a view; null: it has none.
const Ellipsoid* inertia_ellipsoid_of(const View& view) {
    const auto found =
        std::find_if(view.ellipsoids.begin(), view.ellipsoids.end(),
                     [](const Ellipsoid& e) { return e.name.element == "ellipsoid"; });
    return found != view.ellipsoids.end() ? &*found : nullptr;
}

// The invariable plane under the ellipsoid of a view; null: it has none. Its centre is the foot of
// the perpendicular from the ellipsoid's.
const Plane* invariable_plane_of(const View& view) {
    if (inertia_ellipsoid_of(view) == nullptr) return nullptr;
    const auto found = std::find_if(view.planes.begin(), view.planes.end(), [](const Plane& plane) {
        return plane.name.element == "plane" && plane.opacity > 0.0;
    });
    return found != view.planes.end() ? &*found : nullptr;
}

}  // namespace

std::string LiveScene::grips_at(const FilmTime& moment) const {
    const Drawing drawing = drawing_at(moment);
    std::vector<std::string> grips;
    for (std::size_t k = 0; k < stage_->panels().size(); ++k) {
        const View& view = drawing.views[k];
        const Projection projection(view);
        // `moved`: the point that a drag moves to the pointer.
        const auto offer = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& moved,
                               std::string_view thing) {
            if (projection.perspective && projection.depth(point) <= projection.near_depth) return;
            const Eigen::Vector2d at = projection.place(point), to = projection.place(moved);
            grips.push_back(JsonObject()
                                .add("panel", k)
                                .add("thing", thing)
                                .add("x", at.x())
                                .add("y", at.y())
                                .add("moved_x", to.x())
                                .add("moved_y", to.y())
                                .line());
        };
        const Ellipsoid* ellipsoid = inertia_ellipsoid_of(view);
        if (ellipsoid == nullptr) continue;
        if (const Plane* plane = invariable_plane_of(view))
            offer(plane->centre, plane->centre, "plane");
        // The farthest tip, for an arrow beyond the plane is drawn in pieces; along ω the ellipsoid
        // is met at the tip of ρ.
        Eigen::Vector3d tip = ellipsoid->centre;
        for (const Arrow& arrow : view.arrows) {
            const bool is_rate = arrow.name.element == "omega" || arrow.name.element == "radius";
            if (!is_rate || arrow.opacity <= 0.0) continue;
            const double reach = (arrow.tip - ellipsoid->centre).norm();
            if (reach > (tip - ellipsoid->centre).norm()) tip = arrow.tip;
        }
        const Eigen::Vector3d along = tip - ellipsoid->centre;
        const double reach = (ellipsoid->half_axes.inverse() * along).norm();
        if (!(reach > 0.0)) continue;
        const Eigen::Vector3d contact = ellipsoid->centre + along / reach;
        offer(contact, contact, "omega");
        if (reach > 1.0 + 1e-6) offer(tip, contact, "omega");
    }
    return json_list(grips);
}

std::optional<Eigen::Vector3d> LiveScene::omega_under(const FilmTime& moment, int panel,
                                                      const Eigen::Vector2d& px) const {
    if (!has_panel(panel)) return std::nullopt;
    const Drawing drawing = drawing_at(moment);
    const View& view = drawing.views[static_cast<std::size_t>(panel)];
    const Ellipsoid* ellipsoid = inertia_ellipsoid_of(view);
    if (ellipsoid == nullptr) return std::nullopt;
    const Projection projection(view);
    const InertiaTensor& inertia = session_.motion.problem().inertia;
    const RotationState now = session_.motion.at(moment.time_s);
    const Eigen::Matrix3d& tensor = inertia.matrix_body();
    const Eigen::Matrix3d body_from_principal = inertia.body_from_principal();
    const Eigen::Vector3d root_moments = inertia.moments_kg_m2().cwiseSqrt();
    const double speed = std::sqrt(now.omega_body.dot(tensor * now.omega_body));
    // u: the tip of ρ in the axes in which the ellipsoid is the unit sphere.
    const auto omega_of = [&](const Eigen::Vector3d& u) {
        return (body_from_principal * (speed * u.cwiseQuotient(root_moments))).eval();
    };
    // In space L keeps its direction, so the body turns with ω; in a panel of its own it does not.
    const bool turns = stage_->panels()[static_cast<std::size_t>(panel)].spec.kind == "space";
    const Eigen::Matrix3d space_from_body = now.space_from_body.toRotationMatrix();
    const Eigen::Matrix3d view_from_space = ellipsoid->half_axes.colwise().normalized() *
                                            (space_from_body * body_from_principal).transpose();
    const Eigen::Vector3d momentum = space_from_body * (tensor * now.omega_body);
    const auto place_of = [&](const Eigen::Vector3d& u) {
        Eigen::Vector3d tip = ellipsoid->half_axes * u;
        if (turns) {
            const Eigen::Vector3d turned = space_from_body * (tensor * omega_of(u));
            const auto back = Eigen::Quaterniond::FromTwoVectors(turned, momentum);
            tip = view_from_space * (back * (view_from_space.transpose() * tip));
        }
        return projection.place(ellipsoid->centre + tip);
    };
    // The tip moves to the pixel by Gauss and Newton's method, damped, so that beyond the outline
    // it stays at the nearest point that is seen.
    Eigen::Vector3d u =
        (body_from_principal.transpose() * now.omega_body).cwiseProduct(root_moments).normalized();
    double off = (place_of(u) - px).squaredNorm(), damping = 1e-3;
    for (int k = 0; k < 60 && off > 1e-6 && damping < 1e6; ++k) {
        const Eigen::Vector3d across = u.unitOrthogonal(), beside = u.cross(across);
        constexpr double step = 1e-5;
        const Eigen::Vector2d here = place_of(u);
        Eigen::Matrix2d slope;
        slope << (place_of((u + step * across).normalized()) - here) / step,
            (place_of((u + step * beside).normalized()) - here) / step;
        const Eigen::Matrix2d normal = slope.transpose() * slope;
        const Eigen::Vector2d turn =
            (normal + damping * normal.trace() * Eigen::Matrix2d::Identity()).inverse() *
            (slope.transpose() * (px - here));
        constexpr double longest_turn = 0.2;
        const double scale = std::min(1.0, longest_turn / std::max(turn.norm(), 1e-12));
        const Eigen::Vector3d tried =
            (u + scale * (turn.x() * across + turn.y() * beside)).normalized();
        const double left = (place_of(tried) - px).squaredNorm();
        if (std::isfinite(left) && left < off) {
            u = tried;
            off = left;
            damping = std::max(0.2 * damping, 1e-9);
        } else {
            damping *= 5.0;
        }
    }
    return omega_of(u);
}

std::optional<RotationState> LiveScene::start_with(
    const FilmTime& moment, const std::optional<Eigen::Vector3d>& omega) const {
    const bool is_free = session_.motion.free_rotation() != nullptr &&
                         session_.scene.start.given_by_conserved() == nullptr;
    if (!omega || !is_free) return std::nullopt;
    MotionProblem problem = session_.motion.problem();
    const RotationState now = session_.motion.at(moment.time_s);
    const Eigen::Matrix3d& inertia = problem.inertia.matrix_body();
    const Eigen::Vector3d kept = now.space_from_body * (inertia * now.omega_body).eval();
    const Eigen::Vector3d turned = now.space_from_body * (inertia * *omega).eval();
    const auto back = Eigen::Quaterniond::FromTwoVectors(turned, kept);
    problem.start = {0.0, back * now.space_from_body, *omega};
    problem.on_separatrix = false;
    return Motion(problem).at(-moment.time_s);
}

std::optional<double> LiveScene::energy_of_plane_at(const FilmTime& moment, int panel,
                                                    const Eigen::Vector2d& px) const {
    if (!has_panel(panel)) return std::nullopt;
    const Drawing drawing = drawing_at(moment);
    const View& view = drawing.views[static_cast<std::size_t>(panel)];
    const Plane* plane = invariable_plane_of(view);
    if (plane == nullptr) return std::nullopt;
    // The point of the perpendicular that is nearest to the line of sight.
    const Eigen::Vector3d centre = inertia_ellipsoid_of(view)->centre;
    const Eigen::Vector3d foot = plane->centre - centre;
    const double distance = foot.norm();
    if (!(distance > 0.0)) return std::nullopt;
    const Projection projection(view);
    const Eigen::Vector3d along = foot / distance, ray = projection.ray(px).normalized();
    const Eigen::Vector3d from = projection.ray_origin(px) - centre;
    const double cosine = along.dot(ray);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < 1e-6) return std::nullopt;
    const double met = (along.dot(from) - cosine * ray.dot(from)) / sine2;
    // The plane's distance is √(2T)/L.
    const MotionProblem& problem = session_.motion.problem();
    const Eigen::Vector3d omega = session_.motion.at(moment.time_s).omega_body;
    const Eigen::Vector3d momentum = problem.inertia.matrix_body() * omega;
    const double energy = 0.5 * omega.dot(momentum), ratio = std::max(met, 0.0) / distance;
    const Eigen::Array3d bounds =
        0.5 * momentum.squaredNorm() / problem.inertia.moments_kg_m2().array();
    return std::clamp(energy * ratio * ratio, bounds.minCoeff(), bounds.maxCoeff());
}

std::optional<Eigen::Vector3d> LiveScene::omega_of_plane_at(const FilmTime& moment, int panel,
                                                            const Eigen::Vector2d& px) const {
    const std::optional<double> energy_J = energy_of_plane_at(moment, panel, px);
    if (!energy_J) return std::nullopt;
    const InertiaTensor& inertia = session_.motion.problem().inertia;
    const Eigen::Vector3d omega = session_.motion.at(moment.time_s).omega_body;
    const double momentum = (inertia.matrix_body() * omega).norm();
    return start_on_polhode(inertia, {*energy_J, momentum, std::nullopt}, omega).omega_body;
}

}  // namespace poinsot
