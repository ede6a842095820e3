// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/spiral_path.h>

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_spiral {
namespace {

constexpr std::size_t fewest_lines = 3;
constexpr int highest_level = 30;    // each level may hold twice the lines of the level before
constexpr double farthest_end = 3.0; // spacings between a line's end and the rim

template <typename... Parts>
Status
refused(std::size_t line, const Parts&... parts)
{
  return {StatusCode::InvalidInput, Diagnostic("radial line ", line, parts...)};
}

Status
checkLine(const RadialLineSet& set, std::size_t i)
{
  const RadialLine& line = set.lines[i];
  if (line.feet.size() < 3 || line.feet.size() != set.lines[0].feet.size())
    return refused(i, " has ", line.feet.size(), " feet and the first line ", set.lines[0].feet.size(),
                   ": give every line the same number of feet, at least three, at equal arc length");
  for (std::size_t k = 0; k < line.feet.size(); ++k) {
    const SurfaceFoot& foot = line.feet[k];
    if (!foot.position.allFinite() || !foot.normal.allFinite() || !foot.direction1.allFinite() || !std::isfinite(foot.curvature1) ||
        !std::isfinite(foot.curvature2))
      return refused(i, ": foot ", k, " is not finite: place, normal and curvatures must be finite");
    if (!foot.valid && k > 0 && k + 1 < line.feet.size())
      return refused(i, " leaves the {scanned surface} at ", Place(foot.position),
                     ": put its points on the surface "
                     "(MLSProjector), or end it there");
  }
  if (line.level < 0 || line.level > highest_level)
    return refused(i, " has the level ", line.level, ": give 0, or for lines to leave out near the centre 1 to ", highest_level);
  if (!(line.length() > 0.0))
    return refused(i, " has no curve: fit one through its feet (fitBSpline)");
  const double before = i > 0 ? set.lines[i - 1].rim_share : -1.0, turned = i > 0 ? set.lines[i - 1].turn_share : -1.0;
  if (!(line.rim_share > before) || !(line.rim_share < 1.0) || !(line.turn_share > turned) || !(line.turn_share < 1.0) ||
      (i == 0 && (line.rim_share != 0.0 || line.turn_share != 0.0)))
    return refused(i, " has the shares ", line.rim_share, " of the rim and ", line.turn_share,
                   " of a turn: both must rise from 0 at the first line to below 1 at the last");
  return Status::success();
}

Status
checkOutlines(const RadialLineSet& set)
{
  if (set.rim.size() < 3)
    return {StatusCode::InvalidInput, "the radial lines have no rim: give the closed outline on which they end"};
  if (!set.inner.empty() && set.inner.size() < 3)
    return {StatusCode::InvalidInput, Diagnostic("the inner boundary of the radial lines has ", set.inner.size(),
                                                 " points: give at least three, or none if the lines start at a centre")};
  for (const auto& [name, loop, corners] :
       {std::tuple("rim", &set.rim, &set.rim_corners), std::tuple("inner boundary", &set.inner, &set.inner_corners)}) {
    for (std::size_t k = 0; k < loop->size(); ++k)
      if (!(*loop)[k].allFinite())
        return {StatusCode::InvalidInput, Diagnostic("point ", k, " of the ", name, " of the radial lines is not finite")};
    for (const std::size_t corner : *corners)
      if (corner >= loop->size())
        return {StatusCode::InvalidInput,
                Diagnostic("the radial lines name corner ", corner, ", but that boundary has ", loop->size(), " points")};
  }
  return Status::success();
}

/** Refuse lines that follow each other clockwise along the rim, seen from outside: the path would run against the sense that was
 *  set, and a climb cut would become a conventional one. */
Status
checkOrder(const RadialLineSet& set)
{
  double left = 0.0; // how far the lines start to the left of the way from line to line along the rim
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    const SurfaceFoot &end = set.lines[i].feet.back(), &start = set.lines[i].feet.front();
    const Eigen::Vector3d along = set.lines[(i + 1) % set.lines.size()].feet.back().position - end.position;
    left += end.normal.cross(along).dot(start.position - end.position);
  }
  if (left > 0.0)
    return Status::success();
  return {StatusCode::InvalidInput, "the radial lines follow each other clockwise along the rim, seen from outside, or their "
                                    "normals point into the material: give them counter-clockwise, with normals that point outwards"};
}

} // namespace

Status
checkLines(const RadialLineSet& set, double spacing)
{
  if (set.lines.size() < fewest_lines)
    return {StatusCode::InvalidInput,
            Diagnostic("there are ", set.lines.size(), " radial lines: a spiral needs at least three, ", "better a hundred")};
  if (const Status status = checkOutlines(set); !status.ok())
    return status;
  for (std::size_t i = 0; i < set.lines.size(); ++i)
    if (const Status status = checkLine(set, i); !status.ok())
      return status;
  if (std::none_of(set.lines.begin(), set.lines.end(), [](const RadialLine& line) { return line.level == 0; }))
    return {StatusCode::InvalidInput, "none of the radial lines has level 0: lines of higher levels are left out near the "
                                      "centre, so give level 0 to some lines"};
  if (const Status status = checkOrder(set); !status.ok())
    return status;
  const double off = (set.lines[0].feet.back().position - set.rim.front()).norm();
  if (!(off <= farthest_end * spacing))
    return {StatusCode::InvalidInput, Diagnostic("the first radial line ends ", off, " {mm} from the first point of the rim, ",
                                                 Place(set.rim.front()), ": reorder the rim's points to begin where that line ends")};
  return Status::success();
}

} // namespace pcl_spiral
