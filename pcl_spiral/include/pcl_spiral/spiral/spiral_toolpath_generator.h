// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From a cloud to one continuous spiral toolpath.
 */
#pragma once

#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/given_parts.h>
#include <pcl_spiral/spiral/spiral_input.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/surface/impl/surface_beyond.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** One continuous spiral over a scanned surface with one boundary (a dome) or two (an annulus).
 *
 *  Runs every stage: ScannedSurface, BoundaryLoops, GapBridging, RadialLines, turns (makeTurns), projection
 *  (putOnSurface), tool axis (setToolAxes). Give it a cloud and three lengths: tool radius, scallop height, chord error, all in
 *  the unit of the cloud (mm). Further input replaces what would be made: a surface (setInputSurface), loops
 *  (setBoundaryLoops), radial lines (setRadialLines), stages of constant scallop height (setStepOverField, setScallopLoops,
 *  setLinkedPath), the whole curve (setCurve, setPlanner); addModifier changes the path before it is checked.
 *  Stage by stage and in one call give the same bytes.
 *  Source: Wu, Chai, Bo, Liu, Wang, China Mechanical Engineering 36(4), 2025, 697-702, with corrected equations.
 *
 *  \p PointOutT: ToolpathPoint, or any other type; ToolpathFields fills the fields it has.
 *  On failure the output is empty and getStatus gives the reason. The input cloud is never changed.
 *  The same input gives the same bytes for any number of threads.
 */
template <typename PointInT, typename PointNT = pcl::Normal, typename PointOutT = ToolpathPoint>
class SpiralToolpathGenerator : public SpiralInput<PointInT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<SpiralToolpathGenerator>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const SpiralToolpathGenerator>; ///< A shared pointer to a constant one.

  /** Boundaries of the surface, as BoundaryLoops or GapBridging give them. None, the default: they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; } ///< The value of setBoundaryLoops.

  /** Lines on which the spiral is drawn, as RadialLines gives them, or the user's own. Then boundaries are not searched for and
   *  gaps are not bridged, and the settings of lines, centre and boundaries have no effect. \see checkLines */
  void setRadialLines(const RadialLineSet& lines) { given_lines_ = lines; }
  const std::optional<RadialLineSet>& getRadialLines() const { return given_lines_; } ///< The value of setRadialLines.
  void clearRadialLines() { given_lines_.reset(); }                                   ///< Takes back setRadialLines.

  /** A path at constant scallop height, from one of its stages on: a field, loops, or a linked path. Boundaries and gaps are looked after
   *  as without it. A field and loops must be of the same surface: their rims are compared with those found here. All must be made with
   *  the same tool radius and scallop height; others are refused. Loops may come with their field: the path is then moved where it would
   *  leave more than the scallop height (LoopLinking). Direction, sense, start point and one-way cutting are those of a linked path.
   *  Only one of these, radial lines, a curve and a planner can be given.
   *  @{ */
  void setStepOverField(const std::shared_ptr<const StepOverDistance>& field) { given_parts_.field = field; }
  void setScallopLoops(const std::vector<ScallopLoop>& loops) { given_parts_.loops = loops; }
  void setLinkedPath(const LinkedPath& path) { given_parts_.linked = path; }
  /** @} */

  /** A curve of the user's own: places near the surface in travel order. Between two of them the curve runs straight, seen from outside,
   *  also over a crest: SpiralPoint::begins_pass lifts the tool there. It gets points for the chord error, is put on the surface, and gets
   *  axes and checks as a spiral does: it must not cross itself, nor run into a hole. How far its rows are apart is not checked, see
   *  MaterialRemoval. SpiralPoint::turn may be 0 everywhere. Direction, sense, start point and one-way cutting are those of the curve. */
  void setCurve(const std::vector<SpiralPoint>& curve) { given_parts_.curve = curve; }

  /** A planner of the user's own makes such a curve, with the surface and its boundaries. Null, the default: none. */
  void setPlanner(const std::shared_ptr<const PathPlanner>& planner) { given_parts_.planner = planner; }

  const GivenParts& getGivenParts() const { return given_parts_; } ///< Field, loops, linked path, curve and planner.
  void clearGivenParts() { given_parts_ = GivenParts(); }          ///< Takes all five back.

  /** The surface beyond that of the scan, which the ball must not cut into either: it rides over it as over tight places. See
   *  surfaceBeyond; none by default, and none with TightHandling::Refuse. */
  void setSurfaceBeyond(std::vector<SurfacePatch> patches) { beyond_ = std::move(patches); }
  const std::vector<SurfacePatch>& getSurfaceBeyond() const { return beyond_; } ///< The value of setSurfaceBeyond.
  /** What ball and shank must not cut into: a path that does is refused, with the place (SpiralReport::blocked_way). To this are always
   *  added the finite points that setIndices leaves out of the cloud, but for those on the surface itself, those of other parts of the
   *  scan that setPartAt or setLargestPart leaves out, and those of clusters that the ball rides over. A gap that is found and in which
   *  there are more of them than a false echo is a hole. Empty by default. The keep-outs of PartRegion go here, too. */
  void setSurroundings(const Surroundings& around) { around_ = around; }
  const Surroundings& getSurroundings() const { return around_; } ///< The value of setSurroundings.

  /** Make the toolpath. \p path is empty on failure; see getStatus. */
  void compute(pcl::PointCloud<PointOutT>& path);

  /** Points of the last path at which the second and each later pass begins: before them the tool is lifted. Empty: one
   *  pass. The arc length does not grow there. */
  const std::vector<std::size_t>& getPassBegins() const { return report_.pass_begins; }

  /** Loops, lines, counts, times and warnings of the last compute. */
  const SpiralReport& getReport() const { return report_; }

private:
  using SpiralInput<PointInT, PointNT>::settings_;
  using SpiralInput<PointInT, PointNT>::modifiers_;
  using SpiralInput<PointInT, PointNT>::progress_;

  /** The turns of one method, and what is to be reported of them if they make the path. */
  struct TurnAttempt {
    SpiralTurns turns;
    TurnPlan plan;
    Diagnostics warnings;
  };

  Status makeSurface(Surface::ConstPtr& surface);
  Status makeLoops(Surface::ConstPtr& surface, const Surroundings& around, std::vector<BoundaryLoop>& loops);
  Status makeLines(const Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, RadialLineSet& lines);
  Status makeCurve(Surface::ConstPtr& surface, const Surroundings& around, StageClock& clock, TurnAttempt& attempt,
                   std::unique_ptr<BallReach>& reach);
  Status makeOfParts(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, StageClock& clock, TurnAttempt& attempt);
  Status makeShortest(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, StageClock& clock, TurnAttempt& attempt);
  Status makeRadial(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, StageClock& clock, TurnAttempt& attempt);
  Status makeOnLines(Surface::ConstPtr& surface, const RadialLineSet& lines, StageClock& clock, TurnAttempt& attempt);
  /** \p alone: no other method is tried after it. */
  Status makeConstantScallop(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, bool alone, StageClock& clock,
                             TurnAttempt& attempt);
  Status makePublished(const Surface& surface, StageClock& clock, SpiralPath& path);
  /** From now on only neighbourhoods are needed, unless a modifier looks at the surface. */
  void giveUpTriangles(Surface::ConstPtr& surface) const
  {
    if (modifiers_.empty())
      surface = Surface::withoutTriangulation(surface);
  }
  Surroundings allAround(const Surface& surface);
  Status makePath(StageClock& clock, Surface::ConstPtr surface, const Surroundings& around, SpiralPath& path);
  Status run(StageClock& clock, SpiralPath& path);

  std::vector<BoundaryLoop> given_loops_;
  std::optional<RadialLineSet> given_lines_;
  GivenParts given_parts_;
  std::vector<SurfacePatch> beyond_;
  Surroundings around_;
  SpiralReport report_;
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/spiral_toolpath_generator.hpp>

namespace pcl_spiral {
extern template class SpiralToolpathGenerator<pcl::PointXYZ>;
extern template class SpiralToolpathGenerator<pcl::PointXYZRGB>;
extern template class SpiralToolpathGenerator<pcl::PointNormal>;
} // namespace pcl_spiral
