#include "drawing/figures/elements/object_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "bodies/flat_face.h"
#include "bodies/solid_meshes.h"
#include "drawing/figures/elements/elements.h"
#include "drawing/stage/drawing_primitives.h"
#include "numerics/least_turn.h"
#include "numerics/power_of_two.h"
#include "numerics/srgb.h"
#include "scene/body_faces.h"

namespace poinsot {

namespace {

double reach_of(const TriangleMesh& mesh) {
    double reach = 0.0;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
        reach = std::max(reach, norm_of(vertex));
    }
    return reach;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= factor;
    return mesh;
}

// A thin cylinder between the origin and a point.
TriangleMesh rod_to(const Eigen::Vector3d& end, double radius) {
    const double length = end.norm();
    constexpr int facets = 24;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.linear() = least_turn(Eigen::Vector3d::UnitZ(), end).toRotationMatrix();
    placement.translation() = 0.5 * end;
    return placed(cylinder_mesh(radius, length, facets), placement);
}

// Balls with volumes proportional to their masses.
TriangleMesh mesh_of_masses(const std::vector<PointMass>& masses, bool rods) {
    double reach = 0.0;
    double heaviest = 0.0;
    for (const PointMass& mass : masses) {
        reach = std::max(reach, mass.at_m.norm());
        heaviest = std::max(heaviest, mass.mass_kg);
    }
    std::vector<TriangleMesh> meshes;
    for (const PointMass& mass : masses) {
        const Eigen::Vector3d at = mass.at_m / reach;
        if (rods) {
            if (at.norm() > 1e-3) meshes.push_back(rod_to(at, 0.012));
            continue;
        }
        // The smallest ball must be visible.
        const double radius = std::max(0.04, 0.12 * std::cbrt(mass.mass_kg / heaviest));
        Eigen::Affine3d placement = Eigen::Affine3d::Identity();
        placement.translation() = at;
        constexpr int quarter_facets = 16;
        meshes.push_back(placed(sphere_mesh(radius, quarter_facets), placement));
    }
    return scaled(joined(meshes), reach);
}

MeshGeometry geometry_of(const TriangleMesh& mesh, double reach_m) {
    ShadedCorners corners = shaded_corners(scaled(mesh, 1.0 / reach_m));
    MeshGeometry geometry;
    geometry.positions = std::move(corners.positions);
    geometry.normals = std::move(corners.normals);
    return geometry;
}

BodyPart part_of(StageStore& store, const TriangleMesh& mesh, double reach_m,
                 const Colour& colour) {
    return {store.keep(geometry_of(mesh, reach_m)), colour};
}

// The twelve edges of a box about the origin.
std::vector<Curve> edges_of_box(const Panel& panel, const Eigen::Vector3d& half_edges,
                                const Eigen::Matrix3d& body_from_principal) {
    std::vector<Curve> edges;
    for (int i = 0; i < 3; ++i) {
        for (int corner = 0; corner < 4; ++corner) {
            Eigen::Vector3d from = -half_edges;
            if ((corner & 1) != 0) from[(i + 1) % 3] *= -1.0;
            if ((corner & 2) != 0) from[(i + 2) % 3] *= -1.0;
            Eigen::Vector3d to = from;
            to[i] *= -1.0;
            edges.push_back(line_between(panel, body_from_principal * from,
                                         body_from_principal * to, panel.stage->theme.solid_lines,
                                         1.6));
            edges.back().hidden_opacity = 0.12;
        }
    }
    return edges;
}

struct ColouredMesh {
    TriangleMesh mesh;
    Colour colour;
};

// Removes the flat face with this outward normal from a body's meshes and returns it.
TriangleMesh taken_face(std::vector<ColouredMesh>& meshes, const Eigen::Vector3d& outward) {
    double at_m = -1e300;
    for (const ColouredMesh& part : meshes)
        at_m = std::max(at_m, farthest_along(part.mesh, outward));
    std::vector<TriangleMesh> faces;
    for (ColouredMesh& part : meshes) {
        PartedMesh parted = parted_at(part.mesh, outward, at_m);
        part.mesh = std::move(parted.rest);
        faces.push_back(std::move(parted.face));
    }
    return joined(faces);
}

// Least and greatest coordinate of a mesh's corners along an axis.
struct Stretch {
    double low, high;
    double length() const { return high - low; }
};
Stretch stretch_of(const std::vector<Eigen::Vector3f>& corners, const Eigen::Vector3d& axis) {
    Stretch stretch{1e300, -1e300};
    for (const Eigen::Vector3f& corner : corners) {
        const double at = axis.dot(corner.cast<double>());
        stretch.low = std::min(stretch.low, at);
        stretch.high = std::max(stretch.high, at);
    }
    return stretch;
}

// The direction of a picture's upper side: as given, or the axis of the body along which the
// picture is stretched least; of two equal ones the later.
Eigen::Vector3d picture_up_of(const FacePictureSpec& spec, const Eigen::Matrix3d& axes,
                              const std::vector<Eigen::Vector3f>& corners) {
    if (!spec.up.empty()) return body_face_named(spec.up).outward(axes);
    const int normal = body_face_named(spec.face).axis;
    const int first = (normal + 1) % 3, second = (normal + 2) % 3;
    const double tall = static_cast<double>(spec.image.height()) / spec.image.width();
    const double ratio = stretch_of(corners, axes.col(first)).length() /
                         stretch_of(corners, axes.col(second)).length();
    const double with_first = std::abs(std::log(ratio / tall));
    const double with_second = std::abs(std::log(1.0 / ratio / tall));
    if (std::abs(with_first - with_second) < 1e-9) return axes.col(std::max(first, second));
    return axes.col(with_first < with_second ? first : second);
}

// The picture over a background colour, which its transparent parts show.
SurfacePicture picture_over(const Image& image, const Colour& ground) {
    SurfacePicture picture{image.width(), image.height(), {}};
    const std::span<const std::uint8_t> rgba = image.bytes();
    const double grounds[] = {ground.r, ground.g, ground.b};
    picture.rgb.resize(rgba.size() / 4 * 3);
    for (std::size_t k = 0; k < rgba.size() / 4; ++k) {
        const double alpha = rgba[4 * k + 3] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint8_t given = rgba[4 * k + c];
            if (rgba[4 * k + 3] == 255) {
                picture.rgb[3 * k + c] = given;
                continue;
            }
            const double light = alpha * linear_from_srgb(given / 255.0) +
                                 (1.0 - alpha) * linear_from_srgb(grounds[c]);
            picture.rgb[3 * k + c] =
                static_cast<std::uint8_t>(std::lround(255.0 * srgb_from_linear(light)));
        }
    }
    return picture;
}

// Puts a picture on a face: its right is up × outward, so that it is not mirrored when seen from
// outside.
void lay_picture(const FacePictureSpec& spec, const Eigen::Matrix3d& axes, const Colour& ground,
                 MeshGeometry& face) {
    const Eigen::Vector3d up = picture_up_of(spec, axes, face.positions);
    const Eigen::Vector3d right = up.cross(body_face_named(spec.face).outward(axes));
    const Stretch across = stretch_of(face.positions, right);
    const Stretch upwards = stretch_of(face.positions, up);
    face.places.reserve(face.positions.size());
    for (const Eigen::Vector3f& corner : face.positions) {
        const Eigen::Vector3d at = corner.cast<double>();
        face.places.emplace_back(Eigen::Vector2d((right.dot(at) - across.low) / across.length(),
                                                 (upwards.high - up.dot(at)) / upwards.length())
                                     .cast<float>());
    }
    face.picture = picture_over(spec.image, ground);
}

// The body's surfaces in body axes.
std::vector<ColouredMesh> meshes_of(const Scene& scene, const Theme& theme) {
    std::vector<ColouredMesh> meshes;
    for (const BodySurface& surface : scene.surfaces) {
        const auto& rgb = surface.srgb;
        meshes.push_back(
            {surface.mesh, rgb ? Colour{(*rgb)[0], (*rgb)[1], (*rgb)[2]} : Colour(theme.solid)});
    }
    if (!meshes.empty()) return meshes;

    const BodySpec& body = scene.body;
    if (body.given == BodySpec::Given::solid) {
        meshes.push_back({solid_mesh(body.shape, body.size_m), theme.solid});
    } else if (body.given == BodySpec::Given::masses) {
        meshes.push_back({mesh_of_masses(body.masses, true), theme.solid});
        meshes.push_back({mesh_of_masses(body.masses, false), theme.solid_lines});
    } else {
        // Moments scaled to order one: any size of the box is correct.
        const Eigen::Vector3d moments = body.inertia.moments_kg_m2();
        Eigen::Affine3d placement = Eigen::Affine3d::Identity();
        placement.linear() = body.inertia.body_from_principal();
        meshes.push_back({placed(box_mesh(box_of_moments(moments / moments.maxCoeff())), placement),
                          theme.solid});
    }
    return meshes;
}

// Whether the scene's body has the edges of a box along the principal axes.
bool is_box(const Scene& scene) {
    if (!scene.surfaces.empty()) return false;
    const BodySpec& body = scene.body;
    return body.given == BodySpec::Given::moments || body.given == BodySpec::Given::tensor ||
           body.shape == "box" || body.shape == "plate";
}

}  // namespace

Eigen::Vector3d box_of_moments(const Eigen::Vector3d& moments_kg_m2) {
    const Eigen::Vector3d& I = moments_kg_m2;
    const double sum = I.sum();
    Eigen::Vector3d edges;
    for (int i = 0; i < 3; ++i) edges[i] = std::sqrt(std::max(0.0, 6.0 * (sum - 2.0 * I[i])));
    return edges.cwiseMax(0.01 * edges.maxCoeff());
}

Eigen::Quaterniond object_from_space(const StageContext& stage) {
    if (!stage.rolling) return Eigen::Quaterniond::Identity();
    const std::vector<PanelSpec>& panels = stage.scene.panels;
    if (std::any_of(panels.begin(), panels.end(),
                    [](const PanelSpec& panel) { return panel.kind == "space"; }))
        return stage.rolling->picture_from_space;
    return least_turn(stage.rolling->construction.normal_space(), Eigen::Vector3d::UnitZ());
}

BodyShape body_shape(const Panel& panel, StageStore& store) {
    const Scene& scene = panel.stage->scene;
    const Eigen::Matrix3d body_from_principal = scene.body.inertia.body_from_principal();
    const Theme& theme = panel.stage->theme;
    std::vector<ColouredMesh> meshes = meshes_of(scene, theme);
    BodyShape shape;
    shape.reach_m = 0.0;
    for (const ColouredMesh& part : meshes) {
        shape.reach_m = std::max(shape.reach_m, reach_of(part.mesh));
    }
    std::vector<BodyPart> pictured;
    for (const FacePictureSpec& spec : scene.object.pictures) {
        const TriangleMesh face =
            taken_face(meshes, body_face_named(spec.face).outward(body_from_principal));
        MeshGeometry geometry = geometry_of(face, shape.reach_m);
        lay_picture(spec, body_from_principal, theme.solid, geometry);
        pictured.push_back({store.keep(std::move(geometry)), theme.solid});
    }
    if (!scene.object.marked_face.empty()) {
        const BodyFace face = body_face_named(scene.object.marked_face);
        meshes.push_back(
            {taken_face(meshes, face.outward(body_from_principal)), theme.solid_lines});
    }
    shape.extents.setZero();
    for (const ColouredMesh& part : meshes) {
        shape.parts.push_back(part_of(store, part.mesh, shape.reach_m, part.colour));
        for (const Eigen::Vector3d& vertex : part.mesh.vertices) {
            const Eigen::Vector3d along = body_from_principal.transpose() * vertex;
            shape.extents = shape.extents.cwiseMax(along / shape.reach_m);
        }
    }
    // Last, since no part of the body is in front of its outermost faces.
    shape.parts.insert(shape.parts.end(), pictured.begin(), pictured.end());
    if (is_box(scene)) shape.edges = edges_of_box(panel, shape.extents, body_from_principal);
    return shape;
}

void add_body(const BodyShape& shape, const Eigen::Affine3d& placement, bool casts_shadow,
              ViewBuilder& builder) {
    for (const BodyPart& part : shape.parts) {
        Mesh mesh;
        mesh.geometry = part.geometry;
        mesh.placement = placement;
        mesh.colour = part.colour;
        mesh.casts_shadow = casts_shadow;
        builder.view.meshes.push_back(mesh);
    }
    for (Curve edge : shape.edges) {
        edge.placement = placement * edge.placement;
        builder.view.curves.push_back(edge);
    }
}

}  // namespace poinsot
