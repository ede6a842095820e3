// SPDX-License-Identifier: BSD-3-Clause
#include "turn_spacing.h"

#include "core/move_pairs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::int64_t few = 64;
constexpr std::int64_t chunk = 1 << 16; // moves between two calls of go_on
constexpr double rounding = 1e-9;       // of a distance

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

/** Looks for crossings and for the least distance between turns. */
class MoveWalk {
public:
  MoveWalk(const SpiralPath& path, const TurnNeighbours& neighbours, double slack)
  : contacts_(path.onSurface()), neighbours_(neighbours), pairs_(contacts_, path.normals, slack, path.passes)
  {
    const auto& counted = neighbours.counted;
    if (std::any_of(counted.begin(), counted.end(), [](std::uint8_t marked) { return marked != 0; }))
      least_.distance = neighbours.within;
    else
      least_.distance = 0.0;
  }

  std::int64_t moves() const { return pairs_.size(); }

  /** Moves from \p begin up to \p end, one in \p every. */
  void walk(std::int64_t begin, std::int64_t end, std::int64_t every)
  {
    const Nearest before = least_;
    const std::int64_t count = (end - begin + every - 1) / every;
    std::int64_t first = first_;
#pragma omp parallel reduction(min : first)
    {
      Nearest mine = before;
#pragma omp for schedule(dynamic, 256) nowait
      for (std::int64_t k = 0; k < count; ++k)
        if (const std::int64_t i = begin + k * every; !pairs_.isLift(static_cast<std::size_t>(i)) && look(i, mine))
          first = std::min(first, i);
#pragma omp critical(pcl_spiral_closest_turns)
      least_ = std::min(least_, mine);
    }
    first_ = first;
  }

  MoveReport figures() const
  {
    MoveReport found;
    if (first_ < moves())
      found.crossing = static_cast<std::size_t>(first_);
    if (least_.point < contacts_.size())
      found.closest = {least_.distance, contacts_[least_.point]};
    return found;
  }

private:
  /** Whether move \p i crosses a later one; \p least: also between the ends of these moves. */
  bool look(std::int64_t i, Nearest& least) const
  {
    bool crosses = false;
    const double reach = least.distance * (1.0 + rounding), aside = reach * pairs_.leftOf(i).norm();
    pairs_.forLater(i, reach, [&](const MovePair& pair) {
      if (std::min(pair.begin, pair.end) > aside || std::max(pair.begin, pair.end) < -aside)
        return; // almost all
      crosses = crosses || (pair.mayCross() && pairs_.cross(pair.first, pair.later));
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        take(pair.first + end, pair.later, least);
        take(pair.later + end, pair.first, least);
      }
    });
    return crosses;
  }

  void take(std::size_t point, std::size_t move, Nearest& least) const
  {
    const auto& [counted, along, apart, within] = neighbours_;
    if (std::abs(along[move] - along[point]) < apart || std::abs(along[move + 1] - along[point]) < apart ||
        !(counted[point] && counted[move] && counted[move + 1]))
      return;
    const MoveDistance from(contacts_[move], contacts_[move + 1], contacts_[point]);
    if (!from.isBeyond(least.distance * (1.0 + rounding)))
      least = std::min(least, {from.distance(), point});
  }

  const Polyline& contacts_;
  const TurnNeighbours& neighbours_;
  MovePairs pairs_;
  Nearest least_;
  std::int64_t first_ = std::numeric_limits<std::int64_t>::max(); ///< that crosses another
};

} // namespace

MoveReport
measureMoves(const SpiralPath& path, const TurnNeighbours& neighbours, double slack, const std::function<bool(double)>& go_on)
{
  MoveWalk moves(path, neighbours, slack);
  moves.walk(0, moves.moves(), few); // few moves first: their least distance is all that the others must search
  for (std::int64_t begin = 0; begin < moves.moves(); begin += chunk) {
    if (go_on && !go_on(static_cast<double>(begin) / static_cast<double>(moves.moves())))
      break;
    moves.walk(begin, std::min(begin + chunk, moves.moves()), 1);
  }
  return moves.figures();
}

} // namespace pcl_spiral
