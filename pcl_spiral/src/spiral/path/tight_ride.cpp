// SPDX-License-Identifier: BSD-3-Clause
#include "tight_ride.h"

#include "path_feet.h"
#include "spiral/outlines/narrow_strip.h"
#include "straightened_ride.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/tight_report.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace pcl_spiral {
namespace {

constexpr int most_rounds = 8;        // of halved moves
constexpr int most_bisections = 10;   // of a jump from place to place
constexpr double way_step = 0.05;     // of the radius: between places that are looked at on a move
constexpr double least_piece = 0.05;  // spacings: shorter moves are not halved again
constexpr double aside_share = 0.1;   // of a flat step-over: how far a straight way may be from the places where the ball rests
constexpr double hairpin_share = 0.5; // of it: what stays beyond the end of a hairpin that is cut off is below the scallop height
constexpr double near_spacings = 6.0; // an unreached place is no farther from an unreached point: the widest void between points

class Ride {
public:
  Ride(const Surface& surface, const BallReach& reach, const SpiralSettings& settings, double longest_step)
  : surface_(surface), reach_(reach), radius_(settings.tool_radius), chord_error_(settings.chord_error),
    step_over_(stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(settings.tool_radius)), longest_(longest_step)
  {}

  bool take(const SpiralPath& path);
  void halveMoves();
  void joinJumps();
  void straighten();
  /** The points without a free place. */
  std::vector<RiddenPoint> unfree() const;
  void write(SpiralPath& path) const;

private:
  void place(RiddenPoint& point) const;
  bool halve();
  bool gouges(const RiddenPoint& from, const RiddenPoint& to) const;
  void join(const RiddenPoint& from, const RiddenPoint& to, int depth, RiddenPath& points) const;

  const Surface& surface_;
  const BallReach& reach_;
  double radius_, chord_error_, step_over_, longest_;
  RiddenPath points_;
};

void
Ride::place(RiddenPoint& point) const
{
  const Eigen::Vector3d touching = point.foot + radius_ * point.normal;
  point.centre = reach_.isNearUnreached(point.foot, near_spacings * surface_.spacing()) ? reach_.centre(point.foot, point.normal)
                                                                                        : reach_.overObstacles(touching, point.normal);
  point.lifted = point.centre != touching;
}

bool
Ride::take(const SpiralPath& path)
{
  points_.resize(path.contacts.size());
  const auto count = static_cast<std::int64_t>(points_.size());
  bool lifted = false;
#pragma omp parallel for schedule(dynamic, 256) reduction(|| : lifted)
  for (std::int64_t i = 0; i < count; ++i) {
    RiddenPoint& point = points_[i];
    point.foot = path.contacts[i];
    point.normal = path.normals[i];
    point.turn = path.turns[i];
    point.over_gap = path.over_gap[i];
    point.fresh = reach_.isNearUnreached(point.foot, longest_ + near_spacings * surface_.spacing()) ||
                  reach_.isNearObstacle(point.foot + radius_ * point.normal, longest_ + 1.1 * radius_) ||
                  reach_.isNearBeyond(point.foot + radius_ * point.normal, longest_ + radius_);
    place(point);
    lifted = lifted || point.lifted;
  }
  for (const std::size_t pass : path.passes)
    points_[pass].begins_pass = true;
  return lifted;
}

/** Puts a point into the middle of each fresh move that needs one. \return whether there were any. */
bool
Ride::halve()
{
  std::vector<std::size_t> ends;
  Polyline queries;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    if (points_[i].fresh && !points_[i].begins_pass && (points_[i].foot - points_[i - 1].foot).norm() > least_piece * surface_.spacing()) {
      ends.push_back(i);
      queries.push_back(0.5 * (points_[i].foot + points_[i - 1].foot));
    }
    points_[i].fresh = false;
  }
  std::vector<SurfaceFoot> feet;
  pathFeet(surface_, queries, feet);
  RiddenPath middles(ends.size());
  const auto count = static_cast<std::int64_t>(ends.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t k = 0; k < count; ++k) {
    const RiddenPoint &from = points_[ends[k] - 1], &to = points_[ends[k]];
    RiddenPoint& middle = middles[k];
    if (!feet[k].valid)
      continue;
    middle.foot = feet[k].position;
    middle.normal = feet[k].normal;
    middle.turn = 0.5f * (from.turn + to.turn);
    middle.over_gap = isOverGap(surface_, middle.foot, feet[k].nearest, feet[k].nearest_distance);
    place(middle);
    const bool any = from.lifted || to.lifted || middle.lifted;
    const double off = (middle.centre - 0.5 * (from.centre + to.centre)).norm();
    middle.fresh = any && (off > chord_error_ || (to.contact(radius_) - from.contact(radius_)).norm() > longest_);
  }
  RiddenPath halved;
  std::size_t next = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (next < ends.size() && ends[next] == i) {
      if (middles[next].fresh) {
        halved.push_back(middles[next]);
        points_[i].fresh = true;
      }
      ++next;
    }
    halved.push_back(points_[i]);
  }
  const bool any = halved.size() > points_.size();
  points_ = std::move(halved);
  return any;
}

void
Ride::halveMoves()
{
  for (int round = 0; round < most_rounds && halve(); ++round)
    ;
}

/** True if the ball cuts too deep on the straight way between two places: deeper than at both, which no place between them would mend. */
bool
Ride::gouges(const RiddenPoint& from, const RiddenPoint& to) const
{
  const double ends = std::max(reach_.excess(from.centre), reach_.excess(to.centre));
  const double most = std::max(chord_error_, ends + 0.5 * chord_error_);
  const auto pieces = static_cast<int>(std::ceil((to.centre - from.centre).norm() / (way_step * radius_)));
  for (int k = 1; k < std::max(2, pieces); ++k)
    if (reach_.excess(from.centre + (to.centre - from.centre) * k / std::max(2, pieces)) > most)
      return true;
  return false;
}

/** Appends points between \p from and \p to, on the way from ball to ball, so that no move is too long or gouges. */
void
Ride::join(const RiddenPoint& from, const RiddenPoint& to, int depth, RiddenPath& points) const
{
  RiddenPoint middle = from;
  middle.begins_pass = false;
  middle.lifted = true;
  middle.foot = 0.5 * (from.foot + to.foot);
  middle.normal = (from.normal + to.normal).norm() > 0.1 ? Eigen::Vector3d((from.normal + to.normal).normalized()) : from.normal;
  middle.centre = 0.5 * (from.centre + to.centre);
  middle.turn = 0.5f * (from.turn + to.turn);
  if (depth >= most_bisections || (!gouges(from, to) && (to.contact(radius_) - from.contact(radius_)).norm() <= longest_))
    return;
  if (reach_.excess(middle.centre) > chord_error_) {
    const Eigen::Vector3d free = reach_.freeAlong(middle.centre, middle.normal);
    if ((free - middle.centre).norm() < 2.0 * radius_)
      middle.centre = free;
  }
  join(from, middle, depth + 1, points);
  points.push_back(middle);
  join(middle, to, depth + 1, points);
}

void
Ride::joinJumps()
{
  RiddenPath joined;
  joined.reserve(points_.size());
  for (const RiddenPoint& point : points_) {
    if (!joined.empty() && !point.begins_pass && (joined.back().lifted || point.lifted)) {
      const RiddenPoint before = joined.back();
      join(before, point, 0, joined);
    }
    joined.push_back(point);
  }
  points_ = std::move(joined);
}

void
Ride::straighten()
{
  points_ = straightenedRide(points_, reach_, {chord_error_, aside_share * step_over_, hairpin_share * step_over_, longest_});
}

std::vector<RiddenPoint>
Ride::unfree() const
{
  std::vector<RiddenPoint> found;
  std::copy_if(points_.begin(), points_.end(), std::back_inserter(found),
               [](const RiddenPoint& point) { return !point.centre.allFinite(); });
  return found;
}

void
Ride::write(SpiralPath& path) const
{
  path = SpiralPath();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const RiddenPoint& point = points_[i];
    if (point.begins_pass)
      path.passes.push_back(i);
    path.contacts.push_back(point.contact(radius_));
    path.feet.push_back(point.foot);
    path.lifts.push_back(static_cast<float>((path.contacts.back() - point.foot).norm()));
    path.normals.push_back(point.normal);
    path.turns.push_back(point.turn);
    path.over_gap.push_back(point.over_gap);
  }
}

/** The refusal of a ball that rests nowhere over the points \p unfree. */
Status
unfreeRefusal(const std::vector<RiddenPoint>& unfree, const BallReach& reach, double tool_radius, double spacing)
{
  constexpr double share = 0.9; // of the largest ball that reaches them
  double largest = tool_radius;
  Polyline feet;
  for (const RiddenPoint& point : unfree) {
    largest = std::min(largest, reach.reach(point.foot, point.normal));
    feet.push_back(point.foot);
  }
  return {StatusCode::Failed,
          Diagnostic("the ball of radius ", tool_radius, " {mm} finds no free place over ", Place(feet.front()), " in turn ",
                     unfree.front().turn, feet.size() > 1 ? Diagnostic(", nor at ", feet.size() - 1, " more places") : "",
                     ": the surface closes round it; ", keepOutText(feet, spacing), "use a smaller tool ({setToolRadius}): a radius of ",
                     Proposed("setToolRadius", share * largest), " {mm} reaches there")};
}

} // namespace

Status
rideTightPlaces(const Surface& surface, const BallReach* given, const SpiralSettings& settings, double longest_step, SpiralPath& path)
{
  const std::unique_ptr<BallReach> own = given ? nullptr : makeReach(surface, settings);
  const BallReach& reach = given ? *given : *own;
  if (reach.unreached().empty() && surface.riddenPoints().empty() && !reach.hasBeyond())
    return Status::success();
  Ride ride(surface, reach, settings, longest_step);
  if (!ride.take(path))
    return Status::success();
  if (const std::vector<RiddenPoint> unfree = ride.unfree(); !unfree.empty())
    return unfreeRefusal(unfree, reach, settings.tool_radius, surface.spacing());
  ride.halveMoves();
  ride.joinJumps();
  ride.straighten();
  if (const std::vector<RiddenPoint> unfree = ride.unfree(); !unfree.empty())
    return unfreeRefusal(unfree, reach, settings.tool_radius, surface.spacing());
  ride.write(path);
  return Status::success();
}

} // namespace pcl_spiral
