// SPDX-License-Identifier: BSD-3-Clause
#include "support/surfaces.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral::test {

/** The outlines in space, with bounding balls round runs of segments. */
struct AnalyticSurface::Rim {
  struct Run {
    Eigen::Vector3d centre;
    double radius;
    std::size_t loop, first, last; ///< segments first .. last - 1
  };
  std::vector<Polyline> loops;
  std::vector<Run> runs;
};

namespace {

constexpr std::size_t run_length = 32;

/** The loop with its vertices and further points, no edge longer than 1/2048 of its length. */
PlaneLoop
subdivided(const PlaneLoop& loop)
{
  double total = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    total += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  PlaneLoop fine;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d edge = loop[(i + 1) % loop.size()] - loop[i];
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / total * 2048.0)));
    for (int k = 0; k < pieces; ++k)
      fine.push_back(loop[i] + edge * (static_cast<double>(k) / pieces));
  }
  return fine;
}

double
segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

} // namespace

double
AnalyticSurface::normalCurvature(const Eigen::Vector3d& x, const Eigen::Vector3d& d) const
{
  return d.dot(hessian(x) * d) / (gradient(x).norm() * d.squaredNorm());
}

std::pair<double, double>
AnalyticSurface::principalCurvatures(const Eigen::Vector3d& x) const
{
  const Eigen::Vector3d n = normal(x);
  const Eigen::Vector3d e = n.unitOrthogonal(), f = n.cross(e);
  const Eigen::Matrix3d h = hessian(x) / gradient(x).norm();
  const double a = e.dot(h * e), b = e.dot(h * f), c = f.dot(h * f);
  const double mean = 0.5 * (a + c), spread = std::hypot(0.5 * (a - c), b);
  return {mean - spread, mean + spread};
}

Eigen::Vector3d
AnalyticSurface::pulled(const Eigen::Vector3d& p) const
{
  Eigen::Vector3d x = p;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d g = gradient(x);
    const Eigen::Vector3d step = value(x) / g.squaredNorm() * g;
    x -= step;
    if (step.squaredNorm() < 1e-22)
      break;
  }
  return x;
}

Eigen::Vector3d
AnalyticSurface::closest(const Eigen::Vector3d& p) const
{
  Eigen::Vector3d x = pulled(p);
  const Eigen::Vector3d g0 = gradient(x);
  double lambda = (p - x).dot(g0) / g0.squaredNorm();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d g = gradient(x);
    Eigen::Matrix4d j;
    j.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + lambda * hessian(x);
    j.topRightCorner<3, 1>() = g;
    j.bottomLeftCorner<1, 3>() = g.transpose();
    j(3, 3) = 0.0;
    Eigen::Vector4d r;
    r << p - x - lambda * g, -value(x);
    const Eigen::Vector4d step = j.partialPivLu().solve(r);
    x += step.head<3>();
    lambda += step[3];
    if (step.head<3>().squaredNorm() < 1e-20)
      break;
  }
  return x;
}

double
AnalyticSurface::signedDistance(const Eigen::Vector3d& p) const
{
  const Eigen::Vector3d x = closest(p);
  return (p - x).dot(normal(x));
}

double
AnalyticSurface::area() const
{
  return region_.integrate([this](const Eigen::Vector2d& u) { return areaElement(u); });
}

const AnalyticSurface::Rim&
AnalyticSurface::rim() const
{
  std::call_once(rim_made_, [this] { rim_ = makeRim(); });
  return *rim_;
}

std::shared_ptr<const AnalyticSurface::Rim>
AnalyticSurface::makeRim() const
{
  auto rim = std::make_shared<Rim>();
  for (const PlaneLoop& loop : region_.loops()) {
    Polyline line;
    for (const Eigen::Vector2d& u : subdivided(loop))
      line.push_back(lift(u));
    for (std::size_t first = 0; first < line.size(); first += run_length) {
      const std::size_t last = std::min(first + run_length, line.size());
      Rim::Run run{0.5 * (line[first] + line[last % line.size()]), 0.0, rim->loops.size(), first, last};
      for (std::size_t i = first; i <= last; ++i)
        run.radius = std::max(run.radius, (line[i % line.size()] - run.centre).norm());
      rim->runs.push_back(run);
    }
    rim->loops.push_back(std::move(line));
  }
  return rim;
}

const std::vector<Polyline>&
AnalyticSurface::outlines() const
{
  return rim().loops;
}

double
AnalyticSurface::rimDistance(const Eigen::Vector3d& x) const
{
  const Rim& r = rim();
  double bound = std::numeric_limits<double>::max();
  for (const Rim::Run& run : r.runs)
    bound = std::min(bound, (x - run.centre).norm() + run.radius);
  double best = bound;
  for (const Rim::Run& run : r.runs) {
    if ((x - run.centre).norm() - run.radius > best)
      continue;
    const Polyline& line = r.loops[run.loop];
    for (std::size_t i = run.first; i < run.last; ++i)
      best = std::min(best, segmentDistance(x, line[i], line[(i + 1) % line.size()]));
  }
  return best;
}

} // namespace pcl_spiral::test
