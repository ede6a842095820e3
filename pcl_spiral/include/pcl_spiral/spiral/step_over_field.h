/** \file
 *  Distance from the rims of a surface, counted in step-overs.
 */
#pragma once

#include <pcl_spiral/spiral/step_over_mesh.h>

#include <vector>

namespace pcl_spiral {

/** D, the distance of each place from the nearest rim or hole along the surface in allowed step-overs, with its ridges: where
 *  fronts from several sides meet. The mesh is refined there to an eighth of a step-over. */
struct StepOverDistance {
  StepOverMesh mesh;
  std::vector<double> distance;      ///< one a node
  std::vector<std::uint8_t> is_fine; ///< one a node: 1 within the refined band about the ridges
  std::vector<std::uint8_t> is_weak; ///< one a triangle: 1 outside the band where |grad D| is below 0.97
  double largest = 0.0;              ///< of distance: the number of loops one inside the other
  double least_length = 0.0;         ///< mm: integral of dA / largest step-over in any direction, and half the rims
  double usual_edge = 0.0;           ///< median edge of the mesh before it was refined, in step-overs
};

/** D on \p surface between \p outlines, its rims and holes. */
Status
measureStepOvers(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options,
                 StepOverDistance& field);

} // namespace pcl_spiral
