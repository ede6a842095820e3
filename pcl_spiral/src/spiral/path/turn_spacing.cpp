// SPDX-License-Identifier: BSD-3-Clause
#include "turn_spacing.h"

#include "core/move_cells.h"

#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
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

/** How far a point is from a move. */
class MoveDistance {
public:
  MoveDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p)
  : along_(b - a), from_(p - a), length_(along_.squaredNorm()), at_(from_.dot(along_))
  {}

  /** Whether the line through the move is farther than \p distance; without a division. False where rounding could decide. */
  bool isBeyond(double distance) const
  {
    constexpr double rounding = 1e-14; // of the square of the way, of which a long move takes almost all away
    return (from_.squaredNorm() * (1.0 - rounding) - distance * distance) * length_ > at_ * at_;
  }
  double distance() const { return (from_ - (length_ > 0.0 ? std::clamp(at_ / length_, 0.0, 1.0) : 0.0) * along_).norm(); }

private:
  Eigen::Vector3d along_, from_;
  double length_, at_;
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
  const auto counts = [&wanted](std::size_t move) { return wanted[move] != 0; };
  const MoveCells cells(contacts, counts, std::max(moves_a_cell * length / static_cast<double>(contacts.size()), reaches_a_cell * within));
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
        const Eigen::Vector3d reach = Eigen::Vector3d::Constant(mine.distance * (1.0 + rounding));
        cells.forBuckets(place - reach, place + reach, [&](const std::uint32_t* first, const std::uint32_t* last) {
          for (const std::uint32_t* move = first; move != last; ++move) {
            const MoveDistance from(contacts[*move], contacts[*move + 1], place);
            if (from.isBeyond(mine.distance * (1.0 + rounding)) || std::abs(along[*move] - along[i]) < apart ||
                std::abs(along[*move + 1] - along[i]) < apart)
              continue;
            mine = std::min(mine, {from.distance(), static_cast<std::size_t>(i)});
          }
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
