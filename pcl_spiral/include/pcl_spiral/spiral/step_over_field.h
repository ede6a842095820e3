// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distance from the boundaries of a surface, counted in step-overs.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_input.h>
#include <pcl_spiral/spiral/impl/step_over_mesh.h>
#include <pcl_spiral/spiral/scallop_loop.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** D, the distance of each place from the nearest rim or hole along the surface, in allowed step-overs. It has ridges where
 *  fronts from several sides meet. In a band about the ridges the mesh is cut to a quarter of a step-over, and it has edges along them. */
struct StepOverDistance {
  using ConstPtr = std::shared_ptr<const StepOverDistance>; ///< A shared pointer to a constant one.

  StepOverMesh mesh;                 ///< nodes and triangles, up to the outlines
  std::vector<double> distance;      ///< one per node
  std::vector<float> edge;           ///< one per node: the usual edge of the mesh there, in step-overs; less where it was cut
  std::vector<std::uint8_t> is_fine; ///< one per node: 1 where the mesh was cut within 1.4 step-overs of a ridge
  std::vector<std::uint8_t> is_weak; ///< one per triangle: 1 outside the band where |grad D| is below 0.97
  double largest = 0.0;              ///< of distance: the number of loops one inside the other
  double least_length = 0.0;         ///< mm: integral of dA / largest step-over in any direction, plus half the boundary length
  StepOverBasis basis;               ///< what it was made with
};

/** D on \p surface between \p outlines, those of its rim and holes. \p progress: called with the share done; false cancels. */
Status measureStepOvers(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options,
                        StepOverDistance& field, const ProgressCallback& progress = {});

/** Ok, or an error if \p field is empty or its arrays do not fit together: for the user's own fields. */
Status checkField(const StepOverDistance& field);

/** Nodes of \p field on its ridges, where fronts from different sides meet at more than 14 degrees. In the order of
 *  the mesh. */
std::vector<std::uint32_t> ridgeNodes(const StepOverDistance& field);

/** The distance of every place of a surface from its nearest rim or hole, counted in step-overs that leave the scallop height,
 *  with its ridges. ScallopLoops draws loops on it.
 *
 *  Takes a cloud or a surface, see SurfaceInput, and its loops. Gaps of the scan are not boundaries: straight triangles cross
 *  them. Use GapBridging before. Lengths in mm. The output does not depend on the number of threads.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class StepOverField : public StepOverInput<PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<StepOverField>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const StepOverField>; ///< A shared pointer to a constant one.

  /** Measure the distance. \p field is null on failure: no cloud, a setting out of range, loops that do not belong to the surface, an
   *  outline along which no boundary of it runs, a surface with a handle, or cancelled; getStatus reports which and where. */
  void compute(StepOverDistance::ConstPtr& field);
  /** The same by value; empty on failure. */
  void compute(StepOverDistance& field);
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/step_over_field.hpp>

namespace pcl_spiral {
extern template class StepOverField<pcl::PointXYZ>;
extern template class StepOverField<pcl::PointXYZRGB>;
extern template class StepOverField<pcl::PointNormal>;
} // namespace pcl_spiral
