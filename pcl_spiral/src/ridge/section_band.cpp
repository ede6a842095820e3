// SPDX-License-Identifier: BSD-3-Clause
#include "section_band.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

using Eigen::Vector3d;

std::vector<BandPoint>
bandPoints(const Surface& surface, const StationLine& rail, double reach)
{
  std::vector<std::uint32_t> station(surface.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(surface.size()); ++i)
    station[i] = surface.isGuessed(i) ? static_cast<std::uint32_t>(rail.size()) : rail.nearestStation(surface.position(i), reach);
  std::vector<BandPoint> points;
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (station[i] < rail.size()) {
      BandPoint point;
      point.place = surface.position(i);
      point.station = station[i];
      points.push_back(point);
    }
  return points;
}

void
placePoints(const StationLine& rail, SectionBand& band)
{
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(band.points.size()); ++i) {
    BandPoint& point = band.points[i];
    const LineFoot foot = rail.foot(point.place, point.station);
    const std::optional<RidgeFrame> frame = ridgeFrame(foot.tangent, band.chord);
    point.u = foot.s;
    point.inside = foot.inside && frame;
    if (point.inside)
      point.local = frame->localOf(point.place - foot.position);
  }
}

SectionPoints
pointsBySection(const SectionBand& band, std::size_t count, double length)
{
  const auto sectionOf = [&](const BandPoint& point) {
    return std::min(static_cast<std::size_t>(point.u / length + 0.5), band.rail.closed() ? count : count - 1) % count;
  };
  SectionPoints sections;
  sections.begin.assign(count + 1, 0);
  for (const BandPoint& point : band.points)
    if (point.inside)
      ++sections.begin[sectionOf(point) + 1];
  for (std::size_t i = 0; i < count; ++i)
    sections.begin[i + 1] += sections.begin[i];
  sections.order.resize(sections.begin.back());
  std::vector<std::uint32_t> next(sections.begin.begin(), sections.begin.end() - 1);
  for (std::uint32_t i = 0; i < band.points.size(); ++i)
    if (band.points[i].inside)
      sections.order[next[sectionOf(band.points[i])]++] = i;
  return sections;
}

} // namespace pcl_spiral
