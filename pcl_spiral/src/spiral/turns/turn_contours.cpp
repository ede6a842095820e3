// SPDX-License-Identifier: BSD-3-Clause
// Places between the stations of a turn function, and on its contours from line to line.
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** Derivative at u[at] of Lagrange's polynomial through points p at u. */
Eigen::Vector3d
lagrangeSlope(const std::vector<double>& u, const Polyline& p, std::size_t at)
{
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < u.size(); ++j) {
    if (j == at)
      continue;
    double weight = 1.0 / (u[j] - u[at]);
    for (std::size_t k = 0; k < u.size(); ++k)
      if (k != at && k != j)
        weight *= (u[at] - u[k]) / (u[j] - u[k]);
    slope += weight * p[j] + p[at] / (u[at] - u[j]);
  }
  return slope;
}

} // namespace

double
TurnFunction::shareAt(std::size_t i, double s) const
{
  const auto& stations = stations_[i];
  const double ds = 1.0 / static_cast<double>(stations.size() - 1);
  const double at = std::clamp(s / lines_[i].stationSpacing(), 0.0, static_cast<double>(stations.size() - 1));
  const std::size_t k = std::min(stations.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  const double r0 = stations[k].rate, r1 = stations[k + 1].rate;
  return stations[k].share + ds * f * (r0 + 0.5 * f * (r1 - r0));
}

double
TurnFunction::arcLengthAtShare(std::size_t i, double share) const
{
  const auto& stations = stations_[i];
  const double ds = 1.0 / static_cast<double>(stations.size() - 1);
  const double wanted = std::clamp(share, 0.0, 1.0);
  const auto above = std::upper_bound(stations.begin() + 1, stations.end() - 1, wanted,
                                      [](double t, const Station& station) { return t < station.share; });
  const auto k = static_cast<std::size_t>(above - stations.begin()) - 1;
  // The rate is linear between stations: the share grows as a quadratic, solved for its root in [0, 1].
  const double r0 = stations[k].rate, change = stations[k + 1].rate - r0;
  const double y = (wanted - stations[k].share) / ds;
  const double root = std::sqrt(std::max(0.0, r0 * r0 + 2.0 * change * y));
  const double f = 2.0 * y / (r0 + root);
  return lines_[i].stationSpacing() * (static_cast<double>(k) + std::clamp(f, 0.0, 1.0));
}

double
TurnFunction::arcLengthAt(std::size_t i, double tau) const
{
  return arcLengthAtShare(i, tau / static_cast<double>(turns_));
}

double
TurnFunction::feedStepAt(std::size_t i, double s) const
{
  const auto& stations = stations_[i];
  const double at = std::clamp(s / lines_[i].stationSpacing(), 0.0, static_cast<double>(stations.size() - 1));
  const std::size_t k = std::min(stations.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  return (1.0 - f) * stations[k].feed_step + f * stations[k + 1].feed_step;
}

Eigen::Vector3d
TurnFunction::positionOn(std::size_t line, double share) const
{
  const double s = arcLengthAtShare(line, share);
  const auto& feet = lines_[line].feet;
  const double at = s / lines_[line].stationSpacing();
  const std::size_t k = std::min(feet.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  return (1.0 - f) * feet[k].position + f * feet[k + 1].position;
}

std::optional<Eigen::Vector3d>
TurnFunction::contourDirection(std::size_t line, std::size_t station, int side) const
{
  const std::size_t n = lines_.size();
  const double share = shareAt(line, lines_[line].stationSpacing() * static_cast<double>(station));
  const Eigen::Vector3d p = positionOn(line, share);
  // A line some steps away, with its place along the rim; at most to the next corner.
  const auto reach = [&](int direction, std::size_t steps, double& u) {
    std::size_t i = line;
    u = lines_[line].rim_share;
    for (std::size_t step = 0; step < steps && (step == 0 || !lines_[i].corner); ++step) {
      const std::size_t next = direction > 0 ? (i + 1) % n : (i + n - 1) % n;
      const double gap = lines_[next].rim_share - lines_[i].rim_share;
      u += direction > 0 ? (gap > 0.0 ? gap : gap + 1.0) : (gap < 0.0 ? gap : gap - 1.0);
      i = next;
    }
    return i;
  };
  for (std::size_t stride = 1;; stride *= 2) {
    std::vector<double> u{lines_[line].rim_share};
    Polyline points{p};
    double closest = std::numeric_limits<double>::max();
    for (const int direction : {-1, 1}) {
      if (side == -direction)
        continue;
      double last = u[0];
      for (std::size_t m = 1; m <= 2; ++m) {
        double place = 0.0;
        const std::size_t i = reach(direction, m * stride, place);
        if (place == last)
          break;
        last = place;
        u.push_back(place);
        points.push_back(positionOn(i, share));
        closest = std::min(closest, (points.back() - p).norm());
      }
    }
    if (u.size() < 2)
      return std::nullopt;
    const bool widest = stride >= n / 16;
    if (closest >= spacing_ || widest)
      return closest > 0.0 ? std::optional<Eigen::Vector3d>(lagrangeSlope(u, points, 0)) : std::nullopt;
  }
}

} // namespace pcl_spiral
