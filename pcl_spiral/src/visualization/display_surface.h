// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scanned surface in pictures.
 */
#pragma once

#include <pcl_spiral/visualization/pictures.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pcl_spiral {

/** Triangles with normals: over the scan, thinned if it has more points than a picture can show, or those of the mesh. */
struct DisplaySurface {
  vtkSmartPointer<vtkPolyData> mesh; ///< point data: normals, and Height along the outer direction, mm
  Eigen::Vector3d low, high;         ///< bounding box of the path, the loops and the mesh
  Eigen::Vector3d outward;           ///< mean normal of the path, unit; zero if the normals cancel out (a ring wall)
  bool of_mesh = false;              ///< the triangles are those of the part
  double spacing = 0.0;              ///< of the drawn points of the scan, or of the samples of a mesh, mm; 0: no points
};

/** Triangulates the shown part of the scan: up to \p beyond of the size of path and loops around them. A mesh is shown whole. */
DisplaySurface displaySurface(const PictureScene& scene, double beyond = 0.0);

/** The faces of a mesh; curved faces in pieces small enough to look round in a picture of \p size mm. */
vtkSmartPointer<vtkPolyData> meshTriangles(const SurfaceMesh& mesh, double size, const Eigen::Vector3d& up);

/** How far a place on the surface may be below the drawn surface, mm: the drawn surface is coarser than the scan. */
double clearance(const DisplaySurface& surface);

/** The triangles that reach into the cube of half edge \p reach round \p centre. */
vtkSmartPointer<vtkPolyData> surfaceNear(const DisplaySurface& surface, const Eigen::Vector3d& centre, double reach);

/** Whether the surface is between \p place, a point on it, and a viewer far away in direction \p towards.
 */
bool hides(const DisplaySurface& surface, const Eigen::Vector3d& place, const Eigen::Vector3d& towards);

} // namespace pcl_spiral
