#include <pcl_spiral/toolpath/location_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double shortest_rim = 8.0; // in spacings: a shorter loop is a flaw of the triangulation
constexpr double standard_deviations = 5.0;
constexpr double rounding = 2.4e-7; // of the largest coordinate: two steps of single precision

double
circumradius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a;
  const double twice_area = u.cross(v).norm();
  const double longest = std::sqrt(std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()}));
  if (u.dot(v) <= 0.0 || u.dot(u - v) <= 0.0 || v.dot(v - u) <= 0.0)
    return 0.5 * longest; // blunt: its own places are nearer to a corner than the circle's middle
  return u.norm() * v.norm() * (u - v).norm() / (2.0 * twice_area);
}

} // namespace

void
LocationSurface::build(std::vector<Eigen::Vector3f> points)
{
  surface_.reset();
  surface_status_ = buildCleanGraph(points, SurfaceGraphOptions(), graph_, source_);
  obstacles_ = PointBlocks(std::move(points));
  rim_ = PointBlocks();
  covering_radius_.clear();
  noise_allowance_ = 0.0;
  if (!surface_status_.ok())
    return;
  surface_ = std::make_unique<MlsSurface>(graph_);
  double magnitude = 0.0;
  for (int d = 0; d < 3; ++d)
    magnitude =
        std::max<double>({magnitude, std::abs(obstacles_.box().low[d]), std::abs(obstacles_.box().high[d])});
  noise_allowance_ = standard_deviations * surface_->noise() + rounding * magnitude;
  findRim();
  findCoveringRadii();
  graph_.dropTriangulation();
}

void
LocationSurface::findRim()
{
  const Triangulation& mesh = graph_.triangulation();
  std::vector<Eigen::Vector3f> corners;
  for (const std::vector<std::uint32_t>& loop : mesh.boundaryLoops()) {
    double length = 0.0;
    for (const std::uint32_t h : loop)
      length += (graph_.position(mesh.target(h)) - graph_.position(mesh.origin(h))).norm();
    if (length > shortest_rim * graph_.spacing())
      for (const std::uint32_t h : loop)
        corners.push_back(graph_.blocks().point(mesh.origin(h)));
  }
  rim_ = PointBlocks(std::move(corners));
}

void
LocationSurface::findCoveringRadii()
{
  const Triangulation& mesh = graph_.triangulation();
  std::vector<float> own(graph_.size(), static_cast<float>(graph_.spacing()));
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& corner = mesh.triangle(t);
    const auto radius = static_cast<float>(
        circumradius(graph_.position(corner[0]), graph_.position(corner[1]), graph_.position(corner[2])));
    for (const std::uint32_t c : corner)
      own[c] = std::max(own[c], radius);
  }
  covering_radius_ = own;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    for (const std::uint32_t c : mesh.triangle(t))
      for (const std::uint32_t other : mesh.triangle(t))
        covering_radius_[c] = std::max(covering_radius_[c], own[other]);
}

} // namespace pcl_spiral
