// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles over a surface that end on its outlines, with lengths in step-overs.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/surface/surface.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A mesh that ends exactly on the outlines of a surface. Parallel arrays, one entry per node; mm. */
struct StepOverMesh {
  Polyline positions;
  std::vector<Eigen::Vector3f> normals; ///< unit, out of the material
  std::vector<StepOverMetric> metric;
  Triangulation triangles;
  std::vector<std::vector<std::uint32_t>> rims; ///< nodes of each outline, in its order, the surface on their left

  std::size_t size() const { return positions.size(); }
};

/** How step-overs are measured. */
struct StepOverOptions {
  double tool_radius = 0.0;    ///< mm
  double scallop_height = 0.0; ///< mm
  double reserve = 0.003;      ///< step-overs are narrower than the height allows by this share
};

/** The mesh of \p surface between \p outlines, which lie on it. Points outside or close to an outline, and triangles that cross
 *  one, are left out; the ragged boundary that remains is joined to the outline. Fails if no boundary of the surface runs along an
 *  outline, and on surfaces with handles. */
Status makeStepOverMesh(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options,
                        StepOverMesh& mesh);

} // namespace pcl_spiral
