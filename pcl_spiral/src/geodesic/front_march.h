/** \file
 *  A front that runs over the triangles of a graph, triangle by triangle.
 */
#pragma once

#include <pcl_spiral/search/surface_graph.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points to visit, by distance in steps of a given width; a bucket is emptied in the order it was filled. */
class BucketQueue {
public:
  BucketQueue(double width, std::size_t buckets) : width_(width), buckets_(buckets) {}

  void push(std::uint32_t point, double distance);
  /** The next entry; false when there is none. An entry may be out of date. */
  bool pop(std::uint32_t& point);

private:
  double width_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::vector<std::uint32_t> current_;
  std::size_t current_bucket_ = 0, next_ = 0, waiting_ = 0;
};

/** Distances known at seeds carried to all points.
 *
 *  A front about a point is a circle about the source at distance 0. In general the front at a point is taken for a
 *  circle about a centre at which the distance would be \p centre: above the distance here where it contracts.
 */
class FrontMarch {
public:
  FrontMarch(const SurfaceGraph& graph, std::vector<double>& distances, std::vector<Eigen::Vector3f>& gradients);

  /** A point whose distance, gradient and centre are known. */
  void addSeed(std::uint32_t point, double distance, const Eigen::Vector3d& gradient, double centre);
  void run();

private:
  bool settled(std::uint32_t v) const { return distances_[v] < 1e300 && !waiting_[v]; }
  void visit(std::uint32_t v);
  /** Update \p j by the front that crosses the edge a - v, in the plane of the triangle. */
  void updateAcross(std::uint32_t a, std::uint32_t v, std::uint32_t j);
  void updateAlong(std::uint32_t v, std::uint32_t j);
  void lower(std::uint32_t j, double distance, const Eigen::Vector3d& from, double centre);
  double commonCentre(std::uint32_t a, std::uint32_t v) const;

  const SurfaceGraph& graph_;
  const Triangulation& mesh_;
  std::vector<double>& distances_;
  std::vector<Eigen::Vector3f>& gradients_;
  std::vector<double> centres_;
  std::vector<std::uint8_t> waiting_;
  BucketQueue queue_;
};

} // namespace pcl_spiral
