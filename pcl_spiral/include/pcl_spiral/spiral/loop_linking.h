// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Links closed loops to one continuous path.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/impl/step_over_input.h>
#include <pcl_spiral/spiral/linked_path.h>
#include <pcl_spiral/spiral/scallop_loop.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** One path over all \p loops, which lie one inside the other, one step-over apart, the rim first. From the rim it spirals inward
 *  to the innermost loop, in ramps one above the other. A bridge joins each loop beside this chain (in other lobes, round
 *  holes) to a neighbour: both loops are cut side by side, and two narrow turns join their ends, so that they are travelled as one.
 *  With \p start the path begins at the rim near that point. Fails if a loop has no neighbour that runs beside it.
 *  With \p one_way there are no bridges, and no part runs against the sense of the rim's loop. Further passes cut what is left beside
 *  the chain. Each is a spiral from the outermost loop left, or a hole, to the innermost one; the nearest pass is next. */
Status linkLoops(const std::vector<ScallopLoop>& loops, LinkedPath& path, const std::optional<Eigen::Vector3d>& start = std::nullopt,
                 bool one_way = false);

/** Points of \p path. They are so close that linear moves keep the chord error of \p settings, on the surface and at the ball's
 *  centre, and the longest step. Points within a fifth of the chord error of a straight move are left out. Of \p turns are set: curve,
 *  the longest move allowed anywhere, and the feet that were found on the way, for putOnSurface. The first point of each pass is marked.
 *  Fails where the path leaves the surface, and for another tool radius or scallop height than those of the path. */
Status samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, SpiralTurns& turns);

/** The same without feet; \p longest_step, mm: the longest move allowed anywhere. The last digits of a path are others then. */
Status samplePath(const LinkedPath& path, const Surface& surface, const SpiralSettings& settings, std::vector<SpiralPoint>& points,
                  double& longest_step);

/** One continuous path over closed loops: linkLoops, then moves the path where it would leave more than the loops, in the given
 *  direction. samplePath gives its points for linear moves. putOnSurface and setToolAxes make it a toolpath.
 *
 *  Takes loops and the field they were drawn on (setInputLoops, setInputField). With loops only, the path is not moved. Missing
 *  input is made: loops from the field as by ScallopLoops, the field from a cloud or surface as by StepOverField.
 *  Lengths in mm. The output does not depend on the number of threads.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class LoopLinking : public FieldInput<PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<LoopLinking>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const LoopLinking>; ///< A shared pointer to a constant one.

  /** Loops as ScallopLoops gives them, or the user's own: one inside the other, one step-over apart, the rim first, the surface
   *  on their left. None, the default: they are made. setInputCloud and setInputSurface clear them. */
  void setInputLoops(const std::vector<ScallopLoop>& loops) { given_scallop_loops_ = loops; }
  const std::vector<ScallopLoop>& getInputLoops() const { return given_scallop_loops_; } ///< The value of setInputLoops.

  /** The scan. Clears a surface, a field and loops. */
  void setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    FieldInput<PointT, PointNT>::setInputCloud(cloud);
    given_scallop_loops_.clear();
  }
  /** \see FieldInput::setInputSurface */
  void setInputSurface(const Surface::ConstPtr& surface) override
  {
    FieldInput<PointT, PointNT>::setInputSurface(surface);
    given_scallop_loops_.clear();
  }

  /** Direction of the path: Outward, the default, ends on the rim; Inward begins there. */
  void setDirection(SpiralDirection direction) { this->settings_.direction = direction; }
  SpiralDirection getDirection() const { return this->settings_.direction; } ///< The value of setDirection.

  /** The path begins (or if outward, ends) at the rim near this point, as near as the loops inside allow. */
  void setStartPoint(const Eigen::Vector3d& point) { this->settings_.start_point = point; }
  const std::optional<Eigen::Vector3d>& getStartPoint() const { return this->settings_.start_point; } ///< The value of setStartPoint.
  void clearStartPoint() { this->settings_.start_point.reset(); }                                     ///< Takes back setStartPoint.

  /** Which way the cutter travels along the rim, seen from outside; CounterClockwise by default. */
  void setSense(SpiralSense sense) { this->settings_.sense = sense; }
  SpiralSense getSense() const { return this->settings_.sense; } ///< The value of setSense.

  /** Never travel against the sense: instead of bridges there are further passes (LinkedPath::passes). Off by default. */
  void setOneWay(bool one_way) { this->settings_.one_way = one_way; }
  bool getOneWay() const { return this->settings_.one_way; } ///< The value of setOneWay.

  /** Link the loops. \p path is empty on failure: no loops, loops or a field of another tool radius or scallop height, a loop without a
   *  neighbour beside it, or any failure of StepOverField; getStatus reports which and where. */
  void compute(LinkedPath& path);

  /** Figures of the last compute; lengths and places of coverage are 0 without a field. */
  const ScallopReport& getReport() const { return figures_; }
  [[deprecated("use getReport")]] const ScallopReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.

private:
  Status checkGivenBasis() const;
  Status run(LinkedPath& path);

  std::vector<ScallopLoop> given_scallop_loops_;
  ScallopReport figures_;
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/loop_linking.hpp>

namespace pcl_spiral {
extern template class LoopLinking<pcl::PointXYZ>;
extern template class LoopLinking<pcl::PointXYZRGB>;
extern template class LoopLinking<pcl::PointNormal>;
} // namespace pcl_spiral
