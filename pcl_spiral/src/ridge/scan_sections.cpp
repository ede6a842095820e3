// SPDX-License-Identifier: BSD-3-Clause
#include "scan_sections.h"

#include "search/neighbour_search.h"

#include <cstdint>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** The point of the scan nearest to each place, however far. */
Polyline
nearestPoints(const Surface& surface, const Polyline& places)
{
  Polyline result(places.size());
#pragma omp parallel
  {
    NeighbourSearch search(surface.graph().blocks(), 1);
#pragma omp for schedule(static)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(places.size()); ++i) {
      const Eigen::Vector3f place = places[i].cast<float>();
      Box box;
      box.extend(place.data());
      search.setRun(box);
      result[i] = surface.position(search.find(places[i]).index[0]);
    }
  }
  return result;
}

/** The next step from \p foot in the plane through \p place across \p tangent. */
Vector3d
stepFrom(const SurfaceFoot& foot, const Vector3d& place, const Vector3d& tangent, double step)
{
  const Vector3d across = foot.normal.cross(tangent), along = across.cross(foot.normal);
  const double off = (foot.position - place).dot(tangent), size = along.dot(tangent);
  return foot.position + step * across.normalized() - (size > 0.0 ? off / size : 0.0) * along;
}

} // namespace

int
ScanSections::reach(std::size_t section, int side) const
{
  int k = 0;
  while (k < most && foot(section, side * (k + 1)).valid)
    ++k;
  return k;
}

ScanSections
walkSections(const Surface& surface, const Polyline& places, const Polyline& tangents, double step, int most)
{
  ScanSections sections;
  sections.most = most;
  sections.step = step;
  sections.feet.resize(places.size() * static_cast<std::size_t>(2 * most + 1));
  std::vector<SurfaceFoot> starts;
  surface.fit().project(nearestPoints(surface, places), starts);
  for (const int side : {-1, 1}) {
    std::vector<SurfaceFoot> last = starts;
    for (int k = 0; k <= most; ++k) {
      for (std::size_t i = 0; i < last.size(); ++i)
        sections.feet[sections.slot(i, side * k)] = last[i];
      std::vector<Vector3d> queries;
      std::vector<std::size_t> which;
      for (std::size_t i = 0; i < last.size(); ++i)
        if (last[i].valid) {
          queries.push_back(stepFrom(last[i], places[i], tangents[i], side * step));
          which.push_back(i);
        }
      std::vector<SurfaceFoot> feet;
      surface.fit().project(queries, feet);
      for (SurfaceFoot& foot : last)
        foot.valid = false;
      for (std::size_t n = 0; n < which.size(); ++n)
        last[which[n]] = feet[n];
    }
  }
  return sections;
}

} // namespace pcl_spiral
