// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths of parallel passes on exact surfaces, to calibrate the checks.
 */
#pragma once

#include "support/checked_path.h"
#include "support/surfaces.h"

#include <functional>
#include <vector>

namespace pcl_spiral::test {

/** Contacts at the given parameters, with the exact normals; turn is the pass. */
class PassBuilder {
public:
  explicit PassBuilder(const AnalyticSurface& surface) : surface_(surface) {}
  void add(const Eigen::Vector2d& u, double pass)
  {
    path_.contacts.push_back(surface_.lift(u));
    path_.normals.push_back(surface_.normal(path_.contacts.back()));
    path_.turns.push_back(pass);
  }
  const CheckedPath& path() const { return path_; }

private:
  const AnalyticSurface& surface_;
  CheckedPath path_;
};

/** Passes along v at the abscissas \p us from v = -half to half, back and forth, contacts \p spacing apart. */
inline CheckedPath
straightPasses(const AnalyticSurface& surface, const std::vector<double>& us, double half, double spacing)
{
  PassBuilder builder(surface);
  const int count = static_cast<int>(2.0 * half / spacing + 0.5);
  for (std::size_t p = 0; p < us.size(); ++p)
    for (int i = 0; i <= count; ++i) {
      const double v = -half + 2.0 * half * i / count;
      builder.add({us[p], p % 2 == 0 ? v : -v}, static_cast<double>(p));
    }
  return builder.path();
}

/** Circles about the origin of the chart with the given radii, \p count contacts each, joined by short moves. */
inline CheckedPath
circularPasses(const AnalyticSurface& surface, const std::vector<double>& radii, const std::function<int(double)>& count)
{
  PassBuilder builder(surface);
  for (std::size_t p = 0; p < radii.size(); ++p) {
    const int n = count(radii[p]);
    for (int i = 0; i <= n; ++i) {
      const double t = 6.283185307179586 * i / n;
      builder.add({radii[p] * std::cos(t), radii[p] * std::sin(t)}, static_cast<double>(p));
    }
  }
  return builder.path();
}

} // namespace pcl_spiral::test
