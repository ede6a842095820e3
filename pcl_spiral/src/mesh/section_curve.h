// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Contacts along the section of a mesh's curved surface. Private to mesh.
 */
#pragma once

#include "graph/level_lines.h"
#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/mesh/mesh_sections.h>
#include <pcl_spiral/mesh/surface_mesh.h>

namespace pcl_spiral {

/** Makes contacts of lines, one line at a time. */
class SectionCurve {
public:
  /** \p distances of the vertices along the unit \p normal of the planes. */
  SectionCurve(const SurfaceMesh& mesh, const SectionSettings& settings, const Eigen::Vector3d& normal,
               const std::vector<double>& distances);

  /** The contacts of \p line, a line of the flat faces with the plane at \p level, put on the curved surface; \p inside is
   *  increased by the number of those put inside faces. */
  DrivePass contacts(const LevelLine& line, double level, std::size_t& inside) const;

private:
  Eigen::Vector3d atCrossing(std::uint32_t half_edge, double level) const;
  DrivePoint onEdge(std::uint32_t half_edge, const Eigen::Vector3d& b) const;
  /** The straight way through a face, in barycentric coordinates, and the corner that lies alone on its side of the plane. */
  struct Chord {
    Eigen::Vector3d from, to;
    int apex;
  };
  Eigen::Vector3d inPlane(const MeshPatch& patch, const Chord& chord, double share, double level) const;
  void addInside(std::uint32_t face, const Chord& chord, double level, DrivePass& pass) const;
  void add(const DrivePoint& point, DrivePass& pass) const;

  const SurfaceMesh& mesh_;
  const SectionSettings& settings_;
  Eigen::Vector3d normal_;
  const std::vector<double>& distances_;
};

} // namespace pcl_spiral
