/** \file
 *  Distance from the rims of a surface, counted in step-overs.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_input.h>
#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** D, the distance of each place from the nearest rim or hole along the surface in allowed step-overs, with its ridges: where
 *  fronts from several sides meet. The mesh is refined there to an eighth of a step-over. */
struct StepOverDistance {
  using ConstPtr = std::shared_ptr<const StepOverDistance>;

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

/** Ok, or \p field is empty or its arrays do not belong together: for fields from elsewhere. */
Status
checkField(const StepOverDistance& field);

/** Nodes of \p field on its ridges: where fronts that come from different sides meet, by more than 14 degrees. In the order of
 *  the mesh. */
std::vector<std::uint32_t>
ridgeNodes(const StepOverDistance& field);

/** The distance of every place of a surface from its nearest rim or hole, counted in step-overs that leave the scallop height,
 *  with its ridges: what ScallopLoops draws loops on.
 *
 *  Takes a cloud or a surface, see SurfaceInput, and its loops. Gaps of the scan are no rims: they are passed over on straight
 *  triangles; GapBridging comes before. Lengths in mm. The output does not depend on the number of threads.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class StepOverField : public StepOverInput<PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<StepOverField>;
  using ConstPtr = pcl::shared_ptr<const StepOverField>;

  /** Measure. \p field is null on failure: no cloud, a setting out of range, loops that do not belong to the surface, an outline
   *  along which no edge of it runs, a surface with a handle, or cancelled; getStatus says which and where. */
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
