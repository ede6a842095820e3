#include "front_march.h"

#include "mesh_walk.h"

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double bucket_width = 0.5; // in spacings
constexpr std::size_t bucket_count = 256;
constexpr double least_gain = 1e-6;  // in spacings: smaller improvements are not passed on
constexpr double flattest = 1e4;     // radius in spacings at which a front counts as straight

} // namespace

void
BucketQueue::push(std::uint32_t point, double distance)
{
  // Beyond the last bucket: put off, and looked at again when its turn comes.
  const double place = std::max(0.0, distance) / width_;
  const double last = static_cast<double>(current_bucket_ + buckets_.size() - 1);
  const auto bucket = static_cast<std::size_t>(std::min(place, last));
  buckets_[std::max(bucket, current_bucket_) % buckets_.size()].push_back(point);
  ++waiting_;
}

bool
BucketQueue::pop(std::uint32_t& point)
{
  while (next_ == current_.size()) {
    if (waiting_ == 0)
      return false;
    current_.clear();
    next_ = 0;
    std::vector<std::uint32_t>& bucket = buckets_[current_bucket_ % buckets_.size()];
    if (bucket.empty())
      ++current_bucket_;
    else
      current_.swap(bucket);
  }
  --waiting_;
  point = current_[next_++];
  return true;
}

FrontMarch::FrontMarch(const SurfaceGraph& graph, std::vector<double>& distances,
                       std::vector<Eigen::Vector3f>& gradients)
: graph_(graph), mesh_(graph.triangulation()), distances_(distances), gradients_(gradients),
  centres_(graph.size(), 0.0), waiting_(graph.size(), 0), queue_(bucket_width * graph.spacing(), bucket_count)
{}

void
FrontMarch::addSeed(std::uint32_t point, double distance, const Eigen::Vector3d& gradient, double centre)
{
  distances_[point] = distance;
  gradients_[point] = gradient.cast<float>();
  centres_[point] = centre;
  waiting_[point] = 1;
  queue_.push(point, distance);
}

void
FrontMarch::run()
{
  std::uint32_t v;
  while (queue_.pop(v))
    if (waiting_[v]) {
      waiting_[v] = 0;
      visit(v);
    }
}

void
FrontMarch::visit(std::uint32_t v)
{
  for (std::uint32_t i = mesh_.outgoingBegin(v); i < mesh_.outgoingBegin(v + 1); ++i) {
    const std::uint32_t h = mesh_.outgoing(i), before = Triangulation::previous(h);
    const std::uint32_t a = mesh_.target(h), b = mesh_.origin(before);
    updateAlong(v, a);
    if (mesh_.opposite(before) == Triangulation::none)
      updateAlong(v, b);
    if (settled(a))
      updateAcross(a, v, b);
    if (settled(b))
      updateAcross(b, v, a);
  }
}

void
FrontMarch::lower(std::uint32_t j, double distance, const Eigen::Vector3d& from, double centre)
{
  const Eigen::Vector3d normal = graph_.normal(j);
  Eigen::Vector3d along = graph_.position(j) - from;
  along -= normal * normal.dot(along);
  addSeed(j, distance, along.normalized(), centre);
}

void
FrontMarch::updateAlong(std::uint32_t v, std::uint32_t j)
{
  if (distances_[j] <= distances_[v])
    return;
  const Eigen::Vector3d from = graph_.position(v);
  const double distance = distances_[v] + (graph_.position(j) - from).norm();
  if (distance < distances_[j] - least_gain * graph_.spacing())
    lower(j, distance, from, centres_[v]);
}

double
FrontMarch::commonCentre(std::uint32_t a, std::uint32_t v) const
{
  if (centres_[a] == centres_[v])
    return centres_[a];
  const double mean = 0.5 * (distances_[a] + distances_[v]);
  const double curvature = 0.5 * (1.0 / (distances_[a] - centres_[a]) + 1.0 / (distances_[v] - centres_[v]));
  const double most = flattest * graph_.spacing();
  return std::abs(curvature) * most > 1.0 ? mean - 1.0 / curvature : mean - most;
}

void
FrontMarch::updateAcross(std::uint32_t a, std::uint32_t v, std::uint32_t j)
{
  const double da = distances_[a], dv = distances_[v], nearer = std::min(da, dv);
  if (distances_[j] <= nearer)
    return;
  const Eigen::Vector3d pa = graph_.position(a), to_j = graph_.position(j) - pa;
  Eigen::Vector3d edge = graph_.position(v) - pa;
  const double c = edge.norm();
  if (!(c > 0.0))
    return;
  edge /= c;
  // In the triangle's plane a is the origin, v lies on x at c, j at (jx, jy) above.
  const double jx = to_j.dot(edge), jy = std::sqrt(std::max(0.0, to_j.squaredNorm() - jx * jx));
  const double centre = commonCentre(a, v);
  const double ra = da - centre, rv = dv - centre;
  if (!(ra * rv > 0.0) || !(jy > 0.0))
    return;
  const double side = ra > 0.0 ? -1.0 : 1.0; // the centre lies behind the edge, or beyond it
  const double cx = ((ra - rv) * (ra + rv) + c * c) / (2.0 * c), squared = (ra - cx) * (ra + cx);
  if (!(squared > 0.0))
    return;
  const double cy = side * std::sqrt(squared);
  if (side > 0.0 && jy >= cy)
    return;
  const double crossing = cx + (jx - cx) * cy / (cy - jy);
  if (!(crossing > 0.0 && crossing < c))
    return;
  const double distance = centre - side * std::hypot(jx - cx, jy - cy);
  if (distance > nearer && distance < distances_[j] - least_gain * graph_.spacing())
    lower(j, distance, pa + crossing * edge, centre);
}

} // namespace pcl_spiral
