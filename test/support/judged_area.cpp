// SPDX-License-Identifier: BSD-3-Clause
#include "support/judged_area.h"

#include "support/checked_path.h"

#include <algorithm>
#include <limits>

namespace pcl_spiral::test {

namespace {

MoveTree
closedTree(Polyline line)
{
  line.push_back(line.front());
  return MoveTree(std::move(line));
}

Region
chartRegion(const AnalyticSurface& surface, const std::vector<Polyline>& rims)
{
  std::vector<PlaneLoop> loops;
  for (const Polyline& rim : rims) {
    loops.emplace_back();
    for (const Eigen::Vector3d& x : rim)
      loops.back().push_back(surface.chart(x));
  }
  return Region(std::move(loops));
}

double
meanDistance(const Polyline& from, const MoveTree& to)
{
  double sum = 0.0;
  for (const Eigen::Vector3d& x : from)
    sum += to.nearest(x).first;
  return sum / static_cast<double>(from.size());
}

} // namespace

JudgedArea::JudgedArea(const AnalyticSurface& surface, const std::vector<Polyline>& rims)
: surface_(surface), region_(chartRegion(surface, rims))
{
  for (const Polyline& rim : rims)
    rims_.push_back(closedTree(rim));
}

double
JudgedArea::rimDistance(const Eigen::Vector3d& x) const
{
  double least = std::numeric_limits<double>::max();
  for (const MoveTree& rim : rims_)
    least = std::min(least, rim.nearest(x).first);
  return least;
}

double
JudgedArea::rimLength() const
{
  double sum = 0.0;
  for (const MoveTree& rim : rims_)
    for (std::size_t i = 0; i < rim.moves(); ++i)
      sum += (rim.points()[i + 1] - rim.points()[i]).norm();
  return sum;
}

double
JudgedArea::leastLength(double radius, double scallop) const
{
  const double inside = region_.integrate([&](const Eigen::Vector2d& u) {
    const double least = surface_.principalCurvatures(surface_.lift(u)).first;
    return surface_.areaElement(u) / exactStepOver(radius, scallop, least);
  });
  return inside + 0.5 * rimLength();
}

std::vector<Polyline>
rimsAlong(const std::vector<Polyline>& truth, std::vector<Polyline> loops, double tolerance, std::size_t& missed)
{
  std::vector<Polyline> rims;
  missed = 0;
  for (const Polyline& outline : truth) {
    const MoveTree tree = closedTree(outline);
    double best = tolerance;
    auto found = loops.end();
    for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
      if (loop->size() < 3)
        continue;
      const double off = std::max(meanDistance(*loop, tree), meanDistance(outline, closedTree(*loop)));
      if (off < best) {
        best = off;
        found = loop;
      }
    }
    missed += found == loops.end() ? 1 : 0;
    rims.push_back(found == loops.end() ? outline : *found);
    if (found != loops.end())
      loops.erase(found);
  }
  return rims;
}

} // namespace pcl_spiral::test
