// SPDX-License-Identifier: BSD-3-Clause
#include "turn_spacing.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double moves_a_cell = 1.5;   // mean length of the moves: most lie in few cells
constexpr double reaches_a_cell = 0.4; // of the widest reach: neighbouring turns are about that far apart
constexpr std::int64_t few = 64;
constexpr double rounding = 1e-9; // of a distance

/** A point of the path, and its distance from another turn. */
struct Nearest {
  double distance = 0.0;
  std::size_t point = std::numeric_limits<std::size_t>::max();

  bool operator<(const Nearest& other) const { return distance < other.distance || (distance == other.distance && point < other.point); }
};

double
distanceFromMove(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a, m = p - a;
  const double length = d.squaredNorm();
  return (m - (length > 0.0 ? std::clamp(m.dot(d) / length, 0.0, 1.0) : 0.0) * d).norm();
}

/** The moves of a path by the cells of a lattice that they run through. Cells share buckets through a hash, which costs only visits. */
class MoveCells {
public:
  /** \p wanted: one entry a point, 1 where the move from it counts. \p width: of a cell, mm. */
  MoveCells(const Polyline& path, const std::vector<std::uint8_t>& wanted, double width) : width_(width)
  {
    std::size_t buckets = 1;
    while (buckets < path.size())
      buckets *= 2;
    mask_ = buckets - 1;
    begin_.assign(buckets + 1, 0);
    forMoves(path, wanted, [&](std::size_t, std::size_t bucket) { ++begin_[bucket]; });
    std::uint32_t before = 0;
    for (std::uint32_t& entry : begin_)
      entry = before += entry;
    moves_.resize(before);
    forMoves(path, wanted, [&](std::size_t move, std::size_t bucket) { moves_[--begin_[bucket]] = static_cast<std::uint32_t>(move); });
  }

  /** Call \p visit(move) for all moves within \p radius of \p p, and others; for some more than once. */
  template <typename Visit>
  void forNear(const Eigen::Vector3d& p, double radius, Visit visit) const
  {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
    forBuckets(p - reach, p + reach, [&](std::size_t bucket) {
      for (std::uint32_t k = begin_[bucket]; k < begin_[bucket + 1]; ++k)
        visit(moves_[k]);
    });
  }

private:
  template <typename Visit>
  void forMoves(const Polyline& path, const std::vector<std::uint8_t>& wanted, Visit visit) const
  {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (!wanted[i])
        continue;
      const Eigen::Vector3d along = path[i + 1] - path[i];
      const int pieces = 1 + static_cast<int>(along.norm() / width_); // a long move runs through few of the cells in its box
      for (int k = 0; k < pieces; ++k) {
        const Eigen::Vector3d a = path[i] + static_cast<double>(k) / pieces * along;
        const Eigen::Vector3d b = k + 1 == pieces ? path[i + 1] : Eigen::Vector3d(path[i] + static_cast<double>(k + 1) / pieces * along);
        forBuckets(a.cwiseMin(b), a.cwiseMax(b), [&](std::size_t bucket) { visit(i, bucket); });
      }
    }
  }
  template <typename Visit>
  void forBuckets(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Visit visit) const
  {
    std::array<std::int64_t, 3> first, last;
    for (int d = 0; d < 3; ++d) {
      first[d] = static_cast<std::int64_t>(std::floor(low[d] / width_));
      last[d] = static_cast<std::int64_t>(std::floor(high[d] / width_));
    }
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
        for (std::int64_t x = first[0]; x <= last[0]; ++x)
          visit((static_cast<std::size_t>(x) + 73856093u * static_cast<std::size_t>(y) + 19349663u * static_cast<std::size_t>(z)) & mask_);
  }

  double width_;
  std::size_t mask_ = 0;
  std::vector<std::uint32_t> begin_, moves_; ///< moves of bucket b: from begin_[b] to begin_[b + 1]
};

} // namespace

ClosestTurns
closestTurns(const SpiralPath& path, const std::vector<std::uint8_t>& counted, const std::vector<double>& along, double apart,
             double within)
{
  ClosestTurns closest;
  if (std::none_of(counted.begin(), counted.end(), [](std::uint8_t marked) { return marked != 0; }))
    return closest;
  const Polyline& contacts = path.onSurface();
  std::vector<std::uint8_t> wanted(contacts.size(), 0);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
    wanted[i] = counted[i] && counted[i + 1] && !beginsPass(path.passes, i + 1);
    length += (contacts[i + 1] - contacts[i]).norm();
  }
  const MoveCells cells(contacts, wanted, std::max(moves_a_cell * length / static_cast<double>(contacts.size()), reaches_a_cell * within));
  Nearest least;
  least.distance = within;
  const auto count = static_cast<std::int64_t>(contacts.size());
  for (const std::int64_t every : {few, std::int64_t{1}}) { // few points first: their least distance is all that the others must search
    const Nearest before = least;
#pragma omp parallel
    {
      Nearest mine = before;
#pragma omp for schedule(dynamic, 1024)
      for (std::int64_t k = 0; k < (count + every - 1) / every; ++k) {
        const std::int64_t i = k * every;
        if (!counted[i])
          continue;
        const Eigen::Vector3d& place = contacts[i];
        cells.forNear(place, mine.distance * (1.0 + rounding), [&](std::uint32_t move) {
          if (std::abs(along[move] - along[i]) < apart || std::abs(along[move + 1] - along[i]) < apart)
            return;
          mine = std::min(mine, {distanceFromMove(place, contacts[move], contacts[move + 1]), static_cast<std::size_t>(i)});
        });
      }
#pragma omp critical(pcl_spiral_closest_turns)
      least = std::min(least, mine);
    }
  }
  if (least.point < contacts.size())
    closest = {least.distance, contacts[least.point]};
  return closest;
}

} // namespace pcl_spiral
