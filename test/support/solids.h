// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Meshes of simple solids, and faults in them.
 */
#pragma once

#include "support/meshes.h"

namespace pcl_spiral::test {

/** A cube from the origin to \p edge in all coordinates, twelve faces. */
TriangleMesh cube(double edge);

/** A closed cylinder along z from 0 to \p height: \p facets all round, flat caps with a vertex in the middle. */
TriangleMesh closedCylinder(double radius, double height, std::uint32_t facets);

/** A sphere about the origin: an icosahedron with faces cut in four, \p rounds times. */
TriangleMesh icoSphere(double radius, int rounds);

/** Each face with its own three vertices, as in an STL file. */
TriangleMesh unwelded(const TriangleMesh& mesh);

} // namespace pcl_spiral::test
