// SPDX-License-Identifier: BSD-3-Clause
#include "row_metric.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int least_stations = 64, most_stations = 4000;

/** Number of stations about a millimetre apart on a line. */
int
stationsOf(const SmoothLine& line)
{
  return static_cast<int>(std::clamp(line.length(), static_cast<double>(least_stations), static_cast<double>(most_stations)));
}

/** The surface about a place, in the direction across a row. */
struct Across {
  double widening = 0.0;  ///< distance of neighbouring rows for each mm of the parameter between them
  double curvature = 0.0; ///< of the normal section, positive where convex
};

Across
acrossAt(const RidgeSurface& surface, bool along_rail, double u, double v)
{
  constexpr double d = 1e-3; // mm, step of the finite differences
  const Vector3d r_u = surface.alongRail(u, v), r_v = surface.alongGenerator(u, v), n = surface.normal(u, v);
  const Vector3d w = n.cross(along_rail ? r_u : r_v).normalized();
  Eigen::Matrix<double, 3, 2> directions;
  directions << r_u, r_v;
  const Eigen::Vector2d share = (directions.transpose() * directions).ldlt().solve(directions.transpose() * w);
  const double du = d * share.x(), dv = d * share.y();
  const Vector3d change = (surface.normal(u + du, v + dv) - surface.normal(u - du, v - dv)) / (2.0 * d);
  return {std::abs((along_rail ? r_v : r_u).dot(w)), change.dot(w)};
}

/** Number of rows per millimetre of the parameter, at the place of a row where most are needed. */
class Density {
public:
  Density(const RidgeSurface& surface, const RidgeRowSettings& settings)
  : surface_(surface), settings_(settings), along_rail_(settings.direction == RidgeDirection::AlongRail)
  {}

  const SmoothLine& across() const { return along_rail_ ? surface_.generator() : surface_.rail(); }

  Status at(double place, double& rows) const
  {
    const SmoothLine& row = along_rail_ ? surface_.rail() : surface_.generator();
    const int stations = std::min(stationsOf(row), 400);
    rows = 0.0;
    for (int k = 0; k <= stations; ++k) {
      const double on_row = row.length() * k / stations, u = along_rail_ ? on_row : place, v = along_rail_ ? place : on_row;
      const Across here = acrossAt(surface_, along_rail_, u, v);
      double step = settings_.step_over;
      if (settings_.spot_size > 0.0)
        step = settings_.spot_size * (1.0 - settings_.overlap);
      if (settings_.tool_radius > 0.0) {
        const auto found = stepOver(settings_.tool_radius, here.curvature, settings_.scallop_height);
        if (!found)
          return {StatusCode::InvalidInput,
                  Diagnostic("the ridge is hollow with radius ", -1.0 / here.curvature, " {mm} at ", Place(surface_.position(u, v)),
                             ", tighter than the tool radius ", settings_.tool_radius, " {mm}: use a smaller tool")};
        step = *found;
      }
      rows = std::max(rows, here.widening / step);
    }
    return Status::success();
  }

private:
  const RidgeSurface& surface_;
  const RidgeRowSettings& settings_;
  bool along_rail_;
};

} // namespace

Status
rowPlaces(const RidgeSurface& surface, const RidgeRowSettings& settings, std::vector<double>& places)
{
  const Density density(surface, settings);
  const SmoothLine& line = density.across();
  const int stations = stationsOf(line);
  const double step = line.length() / stations;
  std::vector<double> sums(static_cast<std::size_t>(stations) + 1, 0.0); // rows up to each station
  std::vector<Status> states(static_cast<std::size_t>(stations));
#pragma omp parallel for schedule(dynamic, 8)
  for (int k = 0; k < stations; ++k)
    states[static_cast<std::size_t>(k)] = density.at((k + 0.5) * step, sums[static_cast<std::size_t>(k) + 1]);
  for (const Status& status : states)
    if (!status.ok())
      return status;
  for (std::size_t k = 1; k < sums.size(); ++k)
    sums[k] = sums[k - 1] + step * sums[k];
  const double count = std::max(1.0, std::ceil(sums.back() - 1e-9));
  constexpr double most_rows = 1e6;
  if (count > most_rows)
    return {StatusCode::InvalidArgument,
            Diagnostic("the ridge needs ", count, " rows, but at most ", most_rows, " are possible: raise the step-over")};
  const double first = line.closed() ? 0.0 : 0.5; // half a step from the edges
  places.clear();
  std::size_t at = 1;
  for (double row = first; row < count; row += 1.0) {
    const double wanted = row * sums.back() / count;
    while (at + 1 < sums.size() && sums[at] < wanted)
      ++at;
    places.push_back(step * (static_cast<double>(at) - 1.0 + (wanted - sums[at - 1]) / (sums[at] - sums[at - 1])));
  }
  return Status::success();
}

} // namespace pcl_spiral
