// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs of SpiralPlanner with trials of remedies. Lengths in mm.
 */
#pragma once

#include "support/plate_scans.h"
#include "support/remedies.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/planning/spiral_planner.h>

#include <functional>
#include <vector>

namespace pcl_spiral::test {

using Spiral = SpiralPlanner<pcl::PointXYZ>;
using SpiralChange = Change<Spiral>;
using SpiralRemedies = std::vector<Remedy<Spiral>>;

inline Said
saySpiral(Spiral& planner)
{
  planner.compute();
  return {planner.getStatus(), planner.getWarnings()};
}

/** A path of a ball of radius 3 over \p scan, with \p change. */
inline RemediedJob
spiralOver(const std::function<ScanPtr()>& scan, const char* words, const SpiralChange& change, const SpiralRemedies& remedies)
{
  const SpiralChange prepare = [scan, change](Spiral& planner) {
    planner.setInputCloud(scan());
    planner.setToolRadius(3.0);
    planner.setScallopHeight(0.05);
    planner.setRemedyTries(0); // what the refusal itself names
    change(planner);
  };
  return remediedJob<Spiral>(words, saySpiral, prepare, remedies);
}

/** A cap of a ball of radius 10. */
inline ScanPtr
dome()
{
  return toCloud(sampleUniform(*ball(10.0, Region({circle({0, 0}, 9.0)})), 3000, 5).points);
}

inline Prism
box(double x0, double x1, double y0, double y1)
{
  return Prism({{x0, y0, 0.0}, {x1, y0, 0.0}, {x1, y1, 0.0}, {x0, y1, 0.0}}, Eigen::Vector3d::UnitZ());
}

inline SpiralChange
keepOut(const Prism& prism)
{
  return [prism](Spiral& s) { s.addKeepOut(prism); };
}

/** Keeps out of the box that the diagnostic has from its place \p first on. */
inline SpiralChange
keepOutOf(std::size_t first)
{
  return [first](Spiral& s, const Diagnostic& said) {
    const Eigen::Vector3d a = said.places().at(first), b = said.places().at(first + 1);
    s.addKeepOut(box(a.x(), b.x(), a.y(), b.y()));
  };
}

inline SpiralChange
crop(const Prism& prism)
{
  return [prism](Spiral& s) { s.setCrop(prism); };
}

inline SpiralChange
method(SpiralMethod method)
{
  return [method](Spiral& s) { s.setMethod(method); };
}

} // namespace pcl_spiral::test
