// SPDX-License-Identifier: BSD-3-Clause
// Where a ball rests that is too large for a place.
#include <pcl_spiral/surface/impl/ball_reach.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double slack = 0.05;                         // of the tolerance: the depth that remains
constexpr int most_pushes = 200;                       // along one line
constexpr int most_slides = 30;                        // to rest; a wedge of planes takes two
constexpr int most_contacts = 16;                      // that hold the ball
constexpr int most_sweeps = 400;                       // over the contacts
constexpr double far_steps = 0.5;                      // of the radius: the longest slide
constexpr double clear_side = 0.3;                     // length of a mean normal that shows the way out
constexpr std::array<double, 3> around{2.0, 1.0, 4.0}; // radii: parts of the surface that show the way out, in the order of trial

/** The centre is at least \p least from \p point in the direction \p away. */
struct HalfSpace {
  Eigen::Vector3d away;
  double least;
};

/** The place nearest to \p target in all \p spaces (Hildreth 1957). */
Eigen::Vector3d
nearestIn(const std::vector<HalfSpace>& spaces, const Eigen::Vector3d& target, double accuracy)
{
  std::vector<double> push(spaces.size(), 0.0);
  Eigen::Vector3d place = target;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double moved = 0.0;
    for (std::size_t k = 0; k < spaces.size(); ++k) {
      const double wanted = std::max(0.0, push[k] + spaces[k].least - spaces[k].away.dot(place));
      place += (wanted - push[k]) * spaces[k].away;
      moved = std::max(moved, std::abs(wanted - push[k]));
      push[k] = wanted;
    }
    if (moved < accuracy)
      break;
  }
  return place;
}

} // namespace

void
BallReach::averageNormals()
{
  const PointBlocks& feet = patches().feet;
  block_normals_.assign(feet.blockCount(), Eigen::Vector3f::Zero());
  for (std::size_t block = 0; block < block_normals_.size(); ++block)
    for (std::size_t i = feet.blockBegin(block); i < feet.blockEnd(block); ++i)
      block_normals_[block] += patches().patches[i].normal / static_cast<float>(feet.blockEnd(block) - feet.blockBegin(block));
}

double
BallReach::excess(const Eigen::Vector3d& centre) const
{
  return -height(centre, 0.0);
}

double
BallReach::height(const Eigen::Vector3d& centre, double most) const
{
  Eigen::Vector3d point;
  const double free = radius_ - tolerance_;
  return nearest(centre, free + most, point) ? (centre - point).norm() - free : most;
}

Eigen::Vector3d
BallReach::wayOut(const Eigen::Vector3d& from, double within) const
{
  const Eigen::Vector3f query = from.cast<float>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double whole = 0.0;
  const auto near = static_cast<float>(within * within);
  const PointBlocks& feet = patches().feet;
  feet.forBlocks([&](const Box& box) { return box.squaredDistance(query.data()) <= near; },
                 [&](std::size_t block) {
                   const Box& box = feet.blockBox(block);
                   const Eigen::Vector3d middle = 0.5 * (Eigen::Vector3f(box.low.data()) + Eigen::Vector3f(box.high.data())).cast<double>();
                   const double inside = std::max(0.0, 1.0 - (middle - from).squaredNorm() / (within * within));
                   sum += inside * inside * block_normals_[block].cast<double>();
                   whole += inside * inside;
                 });
  const Eigen::Vector3d mean = whole > 0.0 ? Eigen::Vector3d(sum / whole) : sum;
  const Eigen::Vector3d out = mean + std::max(0.0, clear_side - mean.norm()) * side_;
  return out.norm() > 0.0 ? out.normalized() : out;
}

Eigen::Vector3d
BallReach::freeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const
{
  const double free = radius_ - tolerance_;
  Eigen::Vector3d point;
  double s = 0.0;
  for (int i = 0; i < most_pushes && nearest(from + s * direction, free - slack * tolerance_, point); ++i) {
    const Eigen::Vector3d apart = point - from;
    const double along = apart.dot(direction);
    s = along + std::sqrt(std::max(0.0, free * free - (apart.squaredNorm() - along * along)));
  }
  return from + s * direction;
}

/** Slides a free ball as near to \p target as the surface allows. Half-spaces at the contacts, seen from the present place, keep the
 *  ball free of them wherever it goes. */
Eigen::Vector3d
BallReach::slid(Eigen::Vector3d centre, const Eigen::Vector3d& target) const
{
  const double free = radius_ - tolerance_, left = slack * tolerance_;
  std::vector<Eigen::Vector3d> contacts;
  std::vector<HalfSpace> spaces;
  const auto spaceOf = [&](const Eigen::Vector3d& contact) {
    const Eigen::Vector3d away = (centre - contact).normalized();
    return HalfSpace{away, std::min(away.dot(contact) + free, away.dot(centre))};
  };
  for (int slide = 0; slide < most_slides; ++slide) {
    spaces.clear();
    for (const Eigen::Vector3d& contact : contacts)
      spaces.push_back(spaceOf(contact));
    Eigen::Vector3d next = centre, point;
    for (bool rests = false; !rests;) {
      next = nearestIn(spaces, target, 0.1 * left);
      const double way = (next - centre).norm();
      if (way > far_steps * radius_)
        next = centre + (next - centre) * (far_steps * radius_ / way);
      rests = !nearest(next, free - left, point);
      if (!rests && spaces.size() >= most_contacts)
        return centre;
      if (!rests) {
        contacts.push_back(point);
        spaces.push_back(spaceOf(point));
      }
    }
    const double moved = (next - centre).norm();
    centre = next;
    if (moved < left)
      break;
    contacts.erase(std::remove_if(contacts.begin(), contacts.end(),
                                  [&](const Eigen::Vector3d& contact) { return (centre - contact).norm() > free + 0.02 * radius_; }),
                   contacts.end());
    if (contacts.size() > most_contacts / 2)
      contacts.erase(contacts.begin(), contacts.end() - most_contacts / 2);
  }
  return centre;
}

/** True if the ball that leaves \p from along \p direction comes free on the outer side of the surface, at \p free. */
bool
BallReach::isFreeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Eigen::Vector3d& free) const
{
  free = freeAlong(from, direction);
  return direction.norm() > 0.5 && excess(free) < 2.0 * slack * tolerance_ && isOutside(free);
}

bool
BallReach::isOutside(const Eigen::Vector3d& centre) const
{
  const PointBlocks& feet = patches().feet;
  const std::size_t place = feet.nearest(centre);
  return (centre - feet.position(place)).dot(patches().patches[place].normal.cast<double>()) > 0.0;
}

Eigen::Vector3d
BallReach::centre(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal) const
{
  const double largest = reach(foot, normal);
  const Eigen::Vector3d target = foot + largest * normal;
  if (largest >= radius_)
    return overObstacles(target, normal);
  Eigen::Vector3d free;
  for (const double radii : around)
    if (isFreeAlong(target, wayOut(target, radii * radius_), free))
      return slid(free, target);
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(side_.normalized()), normal})
    if (isFreeAlong(target, direction, free))
      return slid(free, target);
  return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}

std::vector<float>
BallReach::heightsLeft() const
{
  const auto count = static_cast<std::int64_t>(unreached_.size());
  std::vector<float> heights(unreached_.size());
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t k = 0; k < count; ++k) {
    const std::size_t i = unreached_[k].index;
    heights[k] = static_cast<float>(std::max(0.0, (centre(position(i), normal(i)) - position(i)).norm() - radius_));
  }
  return heights;
}

} // namespace pcl_spiral
