// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scanned surface as it is drawn.
 */
#pragma once

#include <pcl_spiral/visualization/pictures.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pcl_spiral {

/** Triangles with normals: over the scan, thinned where it has more points than a picture can show, or those of the mesh. */
struct DisplaySurface {
  vtkSmartPointer<vtkPolyData> mesh; ///< point data: normals, and Height along the outer direction, mm
  Eigen::Vector3d low, high;         ///< bounding box of the path, the loops and the mesh
  Eigen::Vector3d outward;           ///< mean normal of the path, unit; zero where it cancels out (a ring wall)
  bool of_mesh = false;              ///< the triangles are the part's own
  double spacing = 0.0;              ///< of the scan's drawn points, or of the samples of a mesh, mm; 0: there are none
};

/** Triangulate what is shown of the scan: up to \p beyond of the size of path and loops around them. A mesh is shown whole. */
DisplaySurface displaySurface(const PictureScene& scene, double beyond = 0.0);

/** The faces of a mesh; curved ones in pieces so small that they look round in a picture of \p size mm. */
vtkSmartPointer<vtkPolyData> meshTriangles(const SurfaceMesh& mesh, double size, const Eigen::Vector3d& up);

/** How far what is drawn on the surface may lie below it, mm: the drawn surface is coarser than the scan. */
double clearance(const DisplaySurface& surface);

/** The triangles that reach into the cube of half edge \p reach about \p centre. */
vtkSmartPointer<vtkPolyData> surfaceNear(const DisplaySurface& surface, const Eigen::Vector3d& centre, double reach);

/** Whether the surface lies between \p place, a point on it, and a viewer far away in direction \p towards.
 */
bool hides(const DisplaySurface& surface, const Eigen::Vector3d& place, const Eigen::Vector3d& towards);

} // namespace pcl_spiral
