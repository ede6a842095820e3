// SPDX-License-Identifier: BSD-3-Clause
#include "support/ridge_scans.h"

#include "support/sampling.h"

namespace pcl_spiral::test {

using Eigen::Vector3d;

std::vector<Vector3d>
scanOf(const ExactRidge& ridge, int along, int across, double noise, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vector3d> points;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const double t = (i + random.uniform()) / along;
      points.push_back(ridge.position(t, (j + random.uniform()) / across));
    }
  return moved(points, noise, seed + 1000);
}

std::vector<Vector3d>
roughPointsOfDie(const ExactRidge& die)
{
  constexpr int spans = 20; // 32 mm each
  constexpr double crest = 0.3;
  std::vector<Vector3d> points;
  for (int k = 0; k <= spans; ++k) {
    const double t = 0.01 + 0.98 * k / spans;
    points.push_back(die.position(t, crest) + (k % 2 ? 3.0 : -3.0) * die.frame(t).col(1));
  }
  return points;
}

} // namespace pcl_spiral::test
