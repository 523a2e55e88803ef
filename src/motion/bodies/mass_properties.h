// Volume, centre of mass and inertia of closed meshes of uniform density, and of bodies made of
// several such parts.
#pragma once

#include <Eigen/Core>
#include <span>

#include "bodies/triangle_mesh.h"

namespace poinsot {

// Mass properties of a solid of unit density, in the axes of its mesh.
struct MassProperties {
    double volume_m3 = 0.0;
    Eigen::Vector3d centre_of_mass_m = Eigen::Vector3d::Zero();
    // About the centre of mass, in kg m² for a density of 1 kg/m³.
    Eigen::Matrix3d inertia_unit_density = Eigen::Matrix3d::Zero();
};

// Computes the mass properties of the polyhedron itself, exact except for rounding. The divergence
// theorem turns the volume integrals of 1, x and x xᵀ into sums over the tetrahedra between the
// triangles and one reference point; their integrals are polynomials of the corners. The reference
// point is first the middle of the mesh, then the centre of mass, so that a distant origin costs no
// digits; the sums are compensated. An inside-out surface has negative volume and inertia; a
// surface that encloses nothing has volume 0. Precondition: a closed surface (mesh/solid_check.h).
// Source: Mirtich, J. Graphics Tools 1 (1996) 31; Tonon, J. Math. Stat. 1 (2005) 8 (tetrahedra);
// Lien & Kajiya, IEEE Comput. Graph. Appl. 4 (1984) 35.
MassProperties mass_properties(const TriangleMesh& mesh);

// A rigid body assembled from parts: mass in kg, inertia in kg m² about its centre of mass.
struct BodyProperties {
    double mass_kg = 0.0;
    Eigen::Vector3d centre_of_mass_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();
};

// The mass properties of one part and its density.
struct DensePart {
    MassProperties shape;
    double density_kg_m3 = 1.0;
};

// Adds the parts by the parallel-axis theorem. Volumes in which parts overlap count twice. Products
// of inertia below 64 epsilon of the trace are rounding errors and become exactly 0; if all
// products are, moments that agree to 64 epsilon become equal, so that the sums preserve the body's
// symmetry.
BodyProperties body_of_parts(std::span<const DensePart> parts);

}  // namespace poinsot
