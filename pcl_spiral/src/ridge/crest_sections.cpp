// SPDX-License-Identifier: BSD-3-Clause
#include "crest_sections.h"

#include "crest_line.h"
#include "rough_line.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Straight fits to \p line within \p reach to either side of each point, because the crest of a noisy scan moves from point to point.
 *  */
Polyline
evened(const Polyline& line, double reach, bool closed)
{
  const auto n = static_cast<std::ptrdiff_t>(line.size());
  const auto most = std::min(static_cast<std::ptrdiff_t>(reach * static_cast<double>(n) / length(line, closed)), (n - 1) / 2);
  Polyline result;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t first = closed ? i - most : std::max<std::ptrdiff_t>(0, i - most),
                         last = closed ? i + most : std::min(n - 1, i + most);
    const double count = static_cast<double>(last - first + 1), middle = 0.5 * static_cast<double>(first + last);
    Vector3d mean = Vector3d::Zero(), rise = Vector3d::Zero();
    double squares = 0.0;
    for (std::ptrdiff_t j = first; j <= last; ++j) {
      const Vector3d& p = line[static_cast<std::size_t>((j + n) % n)];
      const double off = static_cast<double>(j) - middle;
      mean += p / count;
      rise += off * p;
      squares += off * off;
    }
    result.push_back(mean + (squares > 0.0 ? (static_cast<double>(i) - middle) / squares : 0.0) * rise);
  }
  return result;
}

/** Refuse rough points far from the scan. */
Status
checkOnScan(const Surface& surface, const ScanRidgeSettings& settings)
{
  const ScanSections found =
      walkSections(surface, settings.rough_points, Polyline(settings.rough_points.size(), Vector3d::UnitX()), surface.spacing(), 0);
  for (std::size_t i = 0; i < settings.rough_points.size(); ++i)
    if (const double off = (found.foot(i, 0).position - settings.rough_points[i]).norm(); !(off <= settings.half_width))
      return {StatusCode::InvalidInput, Diagnostic("rough point ", i, " at ", Place(settings.rough_points[i]), " is ", off,
                                                   " {mm} away from the scan, more than the half width of ", settings.half_width,
                                                   " {mm}: give places on the ridge, in the scan's unit ({setRoughPoints})")};
  return Status::success();
}

/** Make sections across \p line, at least a few spacings apart. */
void
walkAbout(const Surface& surface, const ScanRidgeSettings& settings, const Polyline& line, CrestSections& crest)
{
  constexpr double steps_across = 24.0, spacings_along = 2.0, most_along = 2000.0;
  const double whole = length(line, settings.closed);
  const double along = std::clamp(whole / (spacings_along * surface.spacing()), 16.0, most_along);
  crest.places = resampled(line, static_cast<std::size_t>(along) + 1, settings.closed);
  crest.tangents.clear();
  const Polyline& places = crest.places;
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = settings.closed ? (i + n - 1) % n : (i > 0 ? i - 1 : 0),
                      after = settings.closed ? (i + 1) % n : std::min(i + 1, n - 1);
    crest.tangents.push_back((places[after] - places[before]).normalized());
  }
  const double step = std::max(surface.spacing(), settings.half_width / steps_across);
  crest.sections = walkSections(surface, places, crest.tangents, step, static_cast<int>(std::ceil(settings.half_width / step)));
}

/** Refuse sections that are too short or not bent. */
Status
checkSections(const ScanRidgeSettings& settings, const CrestSections& crest)
{
  constexpr double least_share = 0.2; // of the half width
  constexpr double least_bend = 8.0;  // degrees
  std::size_t worst = 0;
  for (const int side : {-1, 1})
    if (const double reach = crest.sections.step * commonReach(crest.sections, side, worst); reach < least_share * settings.half_width)
      return {StatusCode::InvalidInput,
              Diagnostic("the band of the ridge leaves the scan at ", Place(crest.places[worst]), ": on one side it ends ",
                         crest.sections.step * crest.sections.reach(worst, side), " {mm} from the crest, but at least ",
                         least_share * settings.half_width, " {mm} are needed for a half width of ", settings.half_width,
                         " {mm}: choose rough points farther from the rim, or a smaller half width ({setHalfWidth})")};
  std::vector<std::pair<double, std::size_t>> bends;
  for (std::size_t i = 0; i < crest.sections.size(); ++i)
    bends.emplace_back(bendOf(crest.sections, i, crest.sections.most, crest.tangents[i]), i);
  std::sort(bends.begin(), bends.end());
  if (const auto& [bend, where] = bends[bends.size() / 3]; bend < least_bend)
    return {StatusCode::InvalidInput,
            Diagnostic("there is no crest between the rough points at ", Place(crest.places[where]), ": across the line the scan bends by ",
                       bend, " {degrees} within the half width, but a ridge bends by at least ", least_bend,
                       ": move the rough points to the ridge ({setRoughPoints}), set a larger half width "
                       "({setHalfWidth}), or flip the normals if it is a hollow ({setFlipNormals})")};
  return Status::success();
}

} // namespace

Status
findCrest(const Surface& surface, const ScanRidgeSettings& settings, CrestSections& crest)
{
  if (const Status status = checkOnScan(surface, settings); !status.ok())
    return status;
  constexpr double radii = 3.0; // of a fit, within which errors of the crest are correlated
  const double even = std::max(settings.half_width, radii * surface.spacing() * std::sqrt(surface.fit().neighbours() / pi));
  const double step = std::max(surface.spacing(), 0.1 * settings.half_width);
  Polyline line = throughPlaces(settings.rough_points, settings.closed, step);
  for (int round = 0; round < 2; ++round) {
    walkAbout(surface, settings, line, crest);
    line = crestOf(surface, crest.sections, settings.closed);
    if (2 * line.size() < crest.places.size())
      return {StatusCode::InvalidInput,
              Diagnostic("the scan ends within the width of a fit at the rough points at ", Place(crest.places[crest.places.size() / 2]),
                         ": no crest can be found; choose rough points where the ridge was scanned ({setRoughPoints})")};
    crest.line = fitLine({evened(line, even, settings.closed), settings.closed, 0.0}).line;
    line.clear();
    for (std::size_t i = 0; i < crest.places.size(); ++i)
      line.push_back(crest.line.position(crest.line.length() * static_cast<double>(i) /
                                         static_cast<double>(settings.closed ? crest.places.size() : crest.places.size() - 1)));
  }
  walkAbout(surface, settings, line, crest);
  return checkSections(settings, crest);
}

int
commonReach(const ScanSections& sections, int side, std::size_t& worst)
{
  std::vector<std::pair<int, std::size_t>> reach;
  for (std::size_t i = 0; i < sections.size(); ++i)
    reach.emplace_back(sections.reach(i, side), i);
  std::sort(reach.begin(), reach.end());
  worst = reach.front().second;
  return reach[reach.size() / 10].first;
}

} // namespace pcl_spiral
