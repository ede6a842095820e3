// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_strip.h"

#include <pcl_spiral/cleaning/impl/point_groups.h>
#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral {
namespace {

/** Places on an outline and on another one, side by side. */
struct Pair {
  Eigen::Vector3d first, second;
  double distance() const { return (first - second).norm(); }
};

/** The pairs of \p outlines[of] with the others that are nearer than \p width, mm. */
std::vector<Pair>
nearPairs(const std::vector<BoundaryLoop>& outlines, std::size_t of, double width)
{
  std::vector<Pair> pairs;
  for (std::size_t o = 0; o < outlines.size(); ++o)
    for (const Eigen::Vector3d& p : o == of ? Polyline() : outlines[o].curve)
      for (const Eigen::Vector3d& q : outlines[of].curve)
        if (const Pair pair{p, q}; pair.distance() < width)
          pairs.push_back(pair);
  return pairs;
}

/** The box about the pairs nearer than \p width that are joined to \p narrowest. */
Eigen::AlignedBox3d
boxAbout(const Pair& narrowest, const std::vector<Pair>& pairs, double width)
{
  std::vector<Eigen::Vector3f> places{narrowest.first.cast<float>()};
  for (const Pair& pair : pairs)
    if (pair.distance() < width)
      places.insert(places.end(), {pair.first.cast<float>(), pair.second.cast<float>()});
  const std::vector<std::uint32_t> group = pointGroups(places, width);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (group[i] == group.front())
      box.extend(places[i].cast<double>());
  return box;
}

} // namespace

Status
refuseNarrowStrip(const std::vector<BoundaryLoop>& outlines, std::size_t of, double spacing)
{
  constexpr double search = 8.0, narrow = 5.0; // spacings; points of a random scan leave breaks across a strip that is wider than narrow
  constexpr double wider = 1.25;               // of the least width: still the same strip
  const std::vector<Pair> pairs = nearPairs(outlines, of, search * spacing);
  if (pairs.empty())
    return Status::success();
  const Pair narrowest =
      *std::min_element(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance() < b.distance(); });
  const double width = narrowest.distance();
  const Eigen::AlignedBox3d box = boxAbout(narrowest, pairs, std::max(narrow * spacing, wider * width));
  return {
      StatusCode::Failed,
      Diagnostic("the surface between two outlines is only ", width, " {mm} wide at ", Place(0.5 * (narrowest.first + narrowest.second)),
                 ", too narrow for points ", spacing,
                 " {mm} apart: {scan it again, more densely}, keep the cutter out of there with a polygon that covers the narrow strip, ",
                 Proposed("addKeepOut", box.min(), box.max()), " ({addKeepOut}), or choose the radial method ({setMethod})")};
}

Diagnostic
keepOutText(const Polyline& places, double spacing)
{
  if (places.empty())
    return "";
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : places)
    box.extend(p);
  const Eigen::Vector3d aside(spacing, spacing, 0.0);
  return Diagnostic("keep the cutter out of what stands there with a polygon that covers all of it, at least ",
                    Proposed("addKeepOut", box.min() - aside, box.max() + aside), " ({addKeepOut}), or ");
}

} // namespace pcl_spiral
