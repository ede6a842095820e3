// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Planners and modifiers of a user's own, for SpiralToolpathGenerator.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/linked_path.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** What a planner works on. It is valid while the planner runs. */
struct PlannerInput {
  const Surface& surface;                      ///< its points, normals, spacing and fit; gaps are bridged as GapHandling defines
  const std::vector<BoundaryLoop>& boundaries; ///< the rim (LoopType::Outer) and the holes (LoopType::Inner) to keep to
  const SpiralSettings& settings;              ///< of the generator: tool radius, scallop height, chord error and the others
  ProgressCallback progress;                   ///< may be empty; false means stop, and the planner returns StatusCode::Cancelled
};

/** Makes a curve in place of the spiral: rows, a trochoid, the path of another program. The generator does the rest: points for the
 *  chord error, projection, tight places, tool axes, checks, the cloud. \see SpiralToolpathGenerator::setPlanner */
class PathPlanner {
public:
  virtual ~PathPlanner() = default; ///< For classes with members of their own.

  /** Makes the points of \p path in travel order, near the surface; see SpiralToolpathGenerator::setCurve. LinkedPath::passes: where
   *  the tool is lifted. LinkedPath::turns may be empty, or has one number for each point, as LinkedPath says; other members are not
   *  used. \return Ok, or an error, which is that of the generator */
  virtual Status plan(const PlannerInput& input, LinkedPath& path) const = 0;
};

/** Changes a path that has its normals and tool axes: another lead in a corner, passes left out. The generator then measures arc lengths
 *  and axes again, and checks normals, lifts, steps, crossings and surroundings; it does not check again whether contacts lie on the
 *  surface, see DeviationEstimation.
 *  \see SpiralToolpathGenerator::addModifier */
class PathModifier {
public:
  virtual ~PathModifier() = default; ///< For classes with members of their own.

  /** Changes \p path, made on \p surface by \p settings. Its arrays stay parallel. \return Ok, or an error, which is that of the
   *  generator */
  virtual Status modify(const Surface& surface, const SpiralSettings& settings, SpiralPath& path) const = 0;
};

} // namespace pcl_spiral
