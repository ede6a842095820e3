// SPDX-License-Identifier: BSD-3-Clause
#include "normal_orientation.h"
#include "side_limits.h"

#include "search/pieces.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

/** Union-find whose members also know whether they are flipped against their root. */
class ParityForest {
public:
  explicit ParityForest(std::size_t n) : parent_(n), parity_(n, 0) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i)
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
  std::uint8_t parity(std::uint32_t i) const
  {
    std::uint8_t sum = 0;
    for (; parent_[i] != i; i = parent_[i])
      sum ^= parity_[i];
    return sum;
  }
  void join(std::uint32_t a, std::uint32_t b, std::uint8_t turned)
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

/** Sums over the area: cosines of each vote, areas that agree, directions to the view point. */
enum SideTerm {
  AsGiven,
  TowardsView,
  TowardsZ,
  Convex,
  Area,
  GivenArea,
  GivenSame,
  ViewSame,
  ZSame,
  ConvexSame,
  ViewX,
  ViewY,
  ViewZ,
  SideTerms
};
using SideSums = Eigen::Array<double, SideTerms, 1>;

constexpr double common_side = 0.9; // share of the given normals that must agree

/** Which vote decides, and by what margin. \p side is the signed sum that decides. */
OuterSide
countVotes(const SideSums& sums, const SurfaceGraphOptions& options, double& side)
{
  OuterSide result;
  if (sums[GivenArea] > 0.0)
    result.normals_agreement = std::max(sums[GivenSame], sums[GivenArea] - sums[GivenSame]) / sums[GivenArea];
  const bool as_given = sums[AsGiven] != 0.0 && (options.trust_normals || result.normals_agreement >= common_side);
  result.normals_ignored = sums[AsGiven] != 0.0 && !as_given;
  const bool by_view = !as_given && options.view_point;
  const bool by_z = !as_given && !by_view && std::abs(sums[TowardsZ]) >= clear_z * sums[Area];
  result.vote = as_given ? SideVote::GivenNormals : by_view ? SideVote::ViewPoint : by_z ? SideVote::PlusZ : SideVote::Convex;
  const SideTerm term = as_given ? AsGiven : by_view ? TowardsView : by_z ? TowardsZ : Convex;
  const SideTerm same = as_given ? GivenSame : by_view ? ViewSame : by_z ? ZSame : ConvexSame;
  side = sums[term];
  const double area = as_given ? sums[GivenArea] : sums[Area], sign = side < 0.0 ? -1.0 : 1.0;
  if (!(area > 0.0))
    return result;
  result.mean_cosine = std::abs(side) / area;
  result.agreement = side < 0.0 ? 1.0 - sums[same] / area : sums[same] / area;
  result.z_cosine = sign * sums[TowardsZ] / sums[Area];
  result.convex_cosine = sign * sums[Convex] / sums[Area];
  result.view_cosine = sign * sums[TowardsView] / sums[Area];
  if (options.view_point)
    result.view_spread = 1.0 - sums.segment<3>(ViewX).matrix().norm() / sums[Area];
  return result;
}

} // namespace

std::vector<std::uint8_t>
consistentSigns(const std::vector<Eigen::Vector3f>& normals, const StarSet& stars)
{
  constexpr int classes = 64; // of weight 1 - |cos|, each joined before the next
  struct Edge {
    std::uint32_t a, b;
  };
  const auto turned = [&](const Edge& e) { return static_cast<std::uint8_t>(normals[e.a].dot(normals[e.b]) < 0.0f); };
  const auto weightOf = [&](const Edge& e) {
    return std::min(classes - 1, static_cast<int>((1.0f - std::abs(normals[e.a].dot(normals[e.b]))) * classes));
  };
  // Edges of the least weight within a piece of the points are joined at once: no other piece uses these points.
  ParityForest forest(normals.size());
  std::vector<std::vector<Edge>> waiting(pieceCount(normals.size()));
  forPieces(normals.size(), [&](std::size_t piece, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t a = begin; a < end; ++a)
      for (std::uint32_t s = stars.begin[a]; s < stars.begin[a + 1]; ++s) {
        const Edge edge{a, stars.neighbourAt(s)};
        if (edge.b >= begin && edge.b < end && weightOf(edge) == 0)
          forest.join(edge.a, edge.b, turned(edge));
        else
          waiting[piece].push_back(edge);
      }
  });
  std::vector<std::vector<Edge>> by_weight(classes);
  for (const auto& edges : waiting)
    for (const Edge& e : edges)
      by_weight[weightOf(e)].push_back(e);
  for (const auto& edges : by_weight)
    for (const Edge& e : edges)
      forest.join(e.a, e.b, turned(e));
  std::vector<std::uint8_t> flipped(normals.size());
  forPoints(normals.size(), [&](std::uint32_t i) { flipped[i] = forest.parity(i); });
  return flipped;
}

OuterSide
chooseOuterSide(const PointBlocks& blocks, const std::vector<Eigen::Vector3f>& normals, const std::vector<float>& radii, double farthest,
                const SurfaceGraphOptions& options, std::vector<std::uint8_t>& flipped)
{
  const Eigen::Vector4d zero = Eigen::Vector4d::Zero();
  const Eigen::Vector4d places = sumOverPoints(blocks.size(), zero, [&](std::uint32_t i, Eigen::Vector4d& sum) {
    if (!(radii[i] > farthest))
      sum += blocks.position(i).homogeneous();
  });
  const Eigen::Vector3d centroid = places.head<3>() / places.w();
  const bool given = options.given_normals.size() == blocks.size();
  const SideSums sums = sumOverPoints(blocks.size(), SideSums(SideSums::Zero()), [&](std::uint32_t i, SideSums& sum) {
    if (radii[i] > farthest)
      return;
    const double weight = static_cast<double>(radii[i]) * radii[i];
    const Eigen::Vector3d n = (flipped[i] ? -1.0 : 1.0) * normals[i].cast<double>();
    const auto vote = [&](SideTerm term, SideTerm same, double cosine) {
      sum[term] += weight * cosine;
      sum[same] += cosine > 0.0 ? weight : 0.0;
    };
    if (options.view_point) {
      const Eigen::Vector3d view = (*options.view_point - blocks.position(i)).normalized();
      vote(TowardsView, ViewSame, n.dot(view));
      sum.segment<3>(ViewX) += weight * view.array();
    }
    if (given) {
      const Eigen::Vector3d as_given = options.given_normals[blocks.originalIndex(i)].cast<double>();
      vote(AsGiven, GivenSame, n.dot(as_given));
      sum[GivenArea] += as_given.isZero(0.0) ? 0.0 : weight;
    }
    vote(TowardsZ, ZSame, n.z());
    vote(Convex, ConvexSame, n.dot((blocks.position(i) - centroid).normalized()));
    sum[Area] += weight;
  });
  double side = 0.0;
  OuterSide result = countVotes(sums, options, side);
  result.flipped = options.flip_normals;
  if (options.flip_normals)
    side = -side;
  if (side < 0.0)
    for (std::uint8_t& f : flipped)
      f ^= 1;
  return result;
}

} // namespace pcl_spiral
