// SPDX-License-Identifier: BSD-3-Clause
#include "stage_input.h"

#include <cmath>
#include <stdexcept>

namespace pcl_spiral::benchmarks {

namespace {

constexpr std::size_t freeform_points = 86000;
constexpr std::size_t line_count = 128;

} // namespace

StageInput::StageInput(std::size_t points) : plan_{points == freeform_points ? test::freeform() : domeSurface(), points} {}

const Points&
StageInput::points(FileOrder order)
{
  Points& points = points_[order];
  if (points.empty())
    points = order == FileOrder::Random ? sampledPoints(plan_) : inSpatialOrder(this->points());
  return points;
}

const Cloud::ConstPtr&
StageInput::cloud(FileOrder order)
{
  Cloud::ConstPtr& cloud = clouds_[order];
  if (!cloud)
    cloud = toCloud(points(order));
  return cloud;
}

const test::Tree::Ptr&
StageInput::tree(FileOrder order)
{
  normals(order);
  return trees_[order];
}

const test::NormalCloud::ConstPtr&
StageInput::normals(FileOrder order)
{
  test::NormalCloud::ConstPtr& normals = normals_[order];
  if (!normals) {
    trees_[order].reset(new test::Tree);
    normals = test::pclNormals(cloud(order), trees_[order], 0);
  }
  return normals;
}

const SurfaceGraph&
StageInput::graph()
{
  if (!graph_)
    require(graph_.emplace().build(points(), SurfaceGraphOptions()));
  return *graph_;
}

const MlsSurface&
StageInput::surface()
{
  return surface_ ? *surface_ : surface_.emplace(graph());
}

Eigen::Vector3d
StageInput::centre() const
{
  const test::Region& region = plan_.surface->region();
  return plan_.surface->lift(0.5 * (region.lower() + region.upper()));
}

const DistanceField&
StageInput::field()
{
  if (!field_ && !field_.emplace().compute(graph(), centre()))
    throw std::runtime_error("the centre does not lie on the cloud");
  return *field_;
}

const Polyline&
StageInput::rim()
{
  if (rim_.empty()) {
    std::vector<BoundaryLoop> loops;
    require(findBoundaryLoops(surface(), BoundaryOptions(), loops));
    rim_ = loops.front().curve;
  }
  return rim_;
}

const std::vector<GeodesicLine>&
StageInput::traces()
{
  if (traces_.empty())
    for (const Eigen::Vector3d& place : resampled(rim(), line_count, true)) {
      traces_.emplace_back();
      traces_.back().points = field().trace(place);
    }
  return traces_;
}

const Polyline&
StageInput::spiral()
{
  if (!spiral_.empty())
    return spiral_;
  const test::Region& region = plan_.surface->region();
  const Eigen::Vector2d middle = 0.5 * (region.lower() + region.upper());
  const double radius = 0.49 * (region.upper() - region.lower()).minCoeff();
  const auto n = static_cast<double>(plan_.points);
  for (double i = 0.0; i < n; ++i) {
    // r = c angle, with steps along it as long as the distance between turns, 2 pi c
    const double r = radius * std::sqrt((i + 0.5) / n), angle = std::sqrt(4.0 * M_PI * (i + 0.5));
    spiral_.push_back(plan_.surface->lift(middle + r * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return spiral_;
}

const std::vector<SurfaceFoot>&
StageInput::spiralFeet()
{
  if (feet_.empty())
    surface().project(spiral(), feet_);
  return feet_;
}

const pcl::PointCloud<ToolpathPoint>&
StageInput::path()
{
  if (!path_.empty())
    return path_;
  double length = 0.0;
  for (std::size_t i = 0; i < spiral().size(); ++i) {
    const Eigen::Vector3d normal = plan_.surface->normal(spiral_[i]);
    if (i > 0)
      length += (spiral_[i] - spiral_[i - 1]).norm();
    ToolpathPoint p;
    p.getVector3fMap() = spiral_[i].cast<float>();
    p.getNormalVector3fMap() = normal.cast<float>();
    p.getAxisVector3fMap() = normal.cast<float>();
    p.arc_length = length;
    p.turn = static_cast<float>(std::sqrt(static_cast<double>(i) / M_PI));
    path_.push_back(p);
  }
  return path_;
}

StageInput&
inputOf(std::size_t points)
{
  static std::size_t size = 0;
  static std::unique_ptr<StageInput> input;
  if (size != points) {
    input.reset();
    input = std::make_unique<StageInput>(points);
    size = points;
  }
  return *input;
}

void
require(const Status& status)
{
  if (!status.ok())
    throw std::runtime_error(status.message());
}

} // namespace pcl_spiral::benchmarks
