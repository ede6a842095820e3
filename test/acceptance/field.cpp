// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include "geodesic/distance_field.h"
#include <pcl_spiral/common/impl/thread_limit.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::acceptance {

namespace {

constexpr double a = 1650.0, b = 860.0;

/** Length of the meridian of the spheroid from its pole, by the parametric angle. */
class Meridian {
public:
  Meridian()
  {
    arc_.assign(1, 0.0);
    const double step = M_PI_2 / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double t = (i + 0.5) * step;
      arc_.push_back(arc_.back() + step * std::hypot(a * std::cos(t), b * std::sin(t)));
    }
  }
  double toPoint(const Eigen::Vector3d& p) const
  {
    const double at = std::atan2(std::hypot(p.x(), p.y()) / a, p.z() / b) / M_PI_2 * pieces;
    const auto i = std::min<std::size_t>(pieces - 1, static_cast<std::size_t>(std::max(0.0, at)));
    return arc_[i] + (at - static_cast<double>(i)) * (arc_[i + 1] - arc_[i]);
  }

private:
  static constexpr int pieces = 200000;
  std::vector<double> arc_;
};

} // namespace

int
judgeField(const Options& options)
{
  Table table("distances from the pole of the spheroid against the exact meridian");
  const ThreadLimit threads(options.threads);
  const test::SurfacePtr surface = test::spheroidCap(a, b);
  const Meridian meridian;
  for (const auto& [points, limit] : {std::pair<std::size_t, double>{200000, 0.15}, {2000000, 0.06}}) {
    std::vector<Eigen::Vector3f> cloud;
    for (const Eigen::Vector3d& p : test::sampleUniform(*surface, points, options.seed).points)
      cloud.push_back(p.cast<float>());
    SurfaceGraph graph;
    const Status status = graph.build(std::move(cloud), {});
    table.holds("a graph is made", status.ok(), status.message());
    DistanceField field;
    table.holds("the pole is on it", field.compute(graph, {0.0, 0.0, b}));
    double squares = 0.0, largest = 0.0;
    std::size_t unreached = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const double error = field.distance(i) - meridian.toPoint(graph.position(i));
      unreached += !std::isfinite(error);
      squares += error * error;
      largest = std::max(largest, std::abs(error));
    }
    const std::string name = std::to_string(points) + " points: ";
    table.atMost(name + "not reached", static_cast<double>(unreached), 0.0, "");
    table.atMost(name + "rms", std::sqrt(squares / static_cast<double>(graph.size())), limit);
    table.note(name + "largest", largest);
  }
  return table.broken();
}

} // namespace pcl_spiral::acceptance
