// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/rim_offset.h>

#include "inner_outlines.h"
#include "rim_band.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double beyond_outline = 2.5; // spacings that the surface extends beyond the outline: fits need points on all sides

/** Extend \p surface beyond its rim and move the outline there. */
Status
moveBeyond(Surface::ConstPtr& surface, double overhang, std::vector<BoundaryLoop>& loops)
{
  const auto rim = std::find_if(loops.begin(), loops.end(), [](const auto& loop) { return loop.type == LoopType::Outer; });
  if (rim == loops.end())
    return {StatusCode::InvalidInput, "none of the loops is an outer one, so there is no rim to go beyond: give the outer loop"};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : rim->curve)
    box.extend(p);
  if (const double part = box.diagonal().norm(); overhang > part)
    return {StatusCode::InvalidArgument,
            Diagnostic("the overhang at the rim is ", overhang, " {mm}, but the part is only ", part,
                       " {mm} from end to end, and says nothing of what is so far beside it: make the distance "
                       "smaller ({setRimOverhang})")};
  const RimBand band(*surface, rim->curve);
  Polyline curve = band.line(overhang, 0.5 * surface->spacing());
  if (curve.size() < 8)
    return {StatusCode::InvalidInput, Diagnostic("no outline is left ", overhang,
                                                 " {mm} beyond the rim: make the distance smaller "
                                                 "({setRimOverhang})")};
  Surface::ConstPtr longer;
  if (const Status status = addPoints(surface, band.points(overhang + beyond_outline * surface->spacing()), longer); !status.ok())
    return status;
  surface = std::move(longer);
  *rim = loopAlong(*surface, std::move(curve), LoopType::Outer);
  return Status::success();
}

} // namespace

Status
offsetOutlines(Surface::ConstPtr& surface, std::vector<BoundaryLoop>& loops, double overhang, double hole_margin)
{
  std::vector<double> margins;
  margins.reserve(loops.size());
  for (const BoundaryLoop& loop : loops)
    margins.push_back(loop.type == LoopType::Outer ? std::max(0.0, -overhang) : loop.type == LoopType::Inner ? hole_margin : 0.0);
  if (std::any_of(margins.begin(), margins.end(), [](double margin) { return margin > 0.0; }))
    if (const Status status = moveInside(*surface, margins, loops); !status.ok())
      return status;
  return overhang > 0.0 ? moveBeyond(surface, overhang, loops) : Status::success();
}

} // namespace pcl_spiral
