// Volume, centre of mass and inertia of closed meshes of uniform density, and of bodies made of
// several such parts.
#pragma once

#include <Eigen/Core>
#include <span>

#include "mesh/triangle_mesh.h"

namespace poinsot {

// Of a solid of unit density, in the axes of its mesh.
struct MassProperties {
    double volume_m3 = 0.0;
    Eigen::Vector3d centre_of_mass_m = Eigen::Vector3d::Zero();
    // About the centre of mass, in kg m² for a density of 1 kg/m³.
    Eigen::Matrix3d inertia_unit_density = Eigen::Matrix3d::Zero();
};

// Mass properties of the polyhedron itself, exact but for rounding: the divergence theorem turns
// the volume integrals of 1, x and x xᵀ into sums over the tetrahedra between the triangles and one
// point, which are polynomials of their corners. That point is first the middle of the mesh, then
// the centre of mass, so that a distant origin costs no digit; the sums are compensated.
// Precondition: a closed surface (mesh/solid_check.h). The volume of one that is inside out is
// negative, and so is its inertia; a surface that encloses nothing has a volume of 0.
// Source: Mirtich, J. Graphics Tools 1 (1996) 31; Tonon, J. Math. Stat. 1 (2005) 8 (tetrahedra);
// Lien & Kajiya, IEEE Comput. Graph. Appl. 4 (1984) 35.
MassProperties mass_properties(const TriangleMesh& mesh);

// A rigid body put together from parts: mass in kg, inertia in kg m² about its centre of mass.
struct BodyProperties {
    double mass_kg = 0.0;
    Eigen::Vector3d centre_of_mass_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();
};

// One part's share.
struct DensePart {
    MassProperties shape;
    double density_kg_m3 = 1.0;
};

// The parts together, by parallel axes. Volumes in which parts overlap count twice. Products of
// inertia below 64 epsilon of the trace are rounding and become exactly 0; where all of them are,
// moments that agree to 64 epsilon become equal, so that a body's symmetry survives the sums.
BodyProperties body_of_parts(std::span<const DensePart> parts);

}  // namespace poinsot
