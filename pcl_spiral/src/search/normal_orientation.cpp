#include "normal_orientation.h"

#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

/** Union-find whose members also know whether they are turned against their root. */
class ParityForest {
public:
  explicit ParityForest(std::size_t n) : parent_(n), parity_(n, 0)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t
  find(std::uint32_t i)
  {
    while (parent_[i] != i) {
      const std::uint32_t p = parent_[i];
      if (parent_[p] != p) { // halve the path
        parity_[i] ^= parity_[p];
        parent_[i] = parent_[p];
      }
      else
        return p;
      i = parent_[i];
    }
    return i;
  }
  std::uint8_t
  parity(std::uint32_t i) const
  {
    std::uint8_t sum = 0;
    for (; parent_[i] != i; i = parent_[i])
      sum ^= parity_[i];
    return sum;
  }
  void
  join(std::uint32_t a, std::uint32_t b, std::uint8_t turned)
  {
    std::uint32_t ra = find(a), rb = find(b);
    if (ra == rb)
      return;
    const std::uint8_t between = parity(a) ^ parity(b) ^ turned;
    if (ra > rb)
      std::swap(ra, rb); // the smaller index is the root
    parent_[rb] = ra;
    parity_[rb] = between;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> parity_;
};

} // namespace

std::vector<std::uint8_t>
consistentSigns(const std::vector<Eigen::Vector3f>& normals, const StarSet& stars)
{
  constexpr int classes = 64; // of weight 1 - |cos|, each joined before the next
  struct Edge {
    std::uint32_t a, b;
  };
  std::vector<std::vector<Edge>> waiting(classes);
  ParityForest forest(normals.size());
  for (std::uint32_t a = 0; a < normals.size(); ++a)
    for (std::uint32_t s = stars.begin[a]; s < stars.begin[a + 1]; ++s) {
      const std::uint32_t b = StarSet::neighbour(stars.spokes[s]);
      const float cosine = normals[a].dot(normals[b]);
      const int weight = std::min(classes - 1, static_cast<int>((1.0f - std::abs(cosine)) * classes));
      if (weight == 0)
        forest.join(a, b, cosine < 0.0f);
      else
        waiting[weight].push_back({a, b});
    }
  for (const auto& edges : waiting)
    for (const Edge& e : edges)
      forest.join(e.a, e.b, normals[e.a].dot(normals[e.b]) < 0.0f);
  std::vector<std::uint8_t> flipped(normals.size());
  for (std::uint32_t i = 0; i < normals.size(); ++i)
    flipped[i] = forest.parity(i);
  return flipped;
}

bool
chooseOuterSide(const PointBlocks& blocks, const std::vector<Eigen::Vector3f>& normals, const std::vector<float>& radii,
                const SurfaceGraphOptions& options, std::vector<std::uint8_t>& flipped)
{
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < blocks.size(); ++i)
    centroid += blocks.position(i);
  centroid /= static_cast<double>(blocks.size());
  const bool given = options.given_normals.size() == blocks.size();
  double as_given = 0.0, towards_view = 0.0, towards_z = 0.0, convex = 0.0, area = 0.0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double weight = static_cast<double>(radii[i]) * radii[i];
    const Eigen::Vector3d n = (flipped[i] ? -1.0 : 1.0) * normals[i].cast<double>();
    if (options.view_point)
      towards_view += weight * n.dot((*options.view_point - blocks.position(i)).normalized());
    if (given)
      as_given += weight * n.dot(options.given_normals[blocks.originalIndex(i)].cast<double>());
    towards_z += weight * n.z();
    convex += weight * n.dot((blocks.position(i) - centroid).normalized());
    area += weight;
  }
  constexpr double clear = 0.1; // of the area-weighted mean cosine
  const bool z_tells = std::abs(towards_z) >= clear * area;
  double side = as_given != 0.0 ? as_given : options.view_point ? towards_view : z_tells ? towards_z : convex;
  if (options.flip_normals)
    side = -side;
  if (side < 0.0)
    for (std::uint8_t& f : flipped)
      f ^= 1;
  return as_given != 0.0 || options.view_point || z_tells;
}

} // namespace pcl_spiral
