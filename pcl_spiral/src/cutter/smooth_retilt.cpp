// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_retilt.h"

#include "asked_location.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr int disc_rings = 6;
constexpr int most_turnings = 8;
constexpr double not_free = 100.0; // costs more than any turn, squared radians
constexpr double cannot = 1e9;     // at an end where the turn has to be none
constexpr double rounding = 1e-9;

/** Whether the cutter touches as it should, held up by no more than \p slack. */
bool
fits(const ToolLocation& location, double slack)
{
  return location.state != LocationState::Unreachable && location.lift <= slack && !location.collision.found();
}

} // namespace

/** A place of a pass. */
struct SmoothRetilt::Place {
  DrivePoint contact; ///< asked for, or touched
  AxisWithSides frame;
  bool asks = false;                   ///< for the contact
  bool wants = false;                  ///< to be turned
  double slack = 0.0;                  ///< mm: a cutter held up by no more than this touches at the contact
  std::vector<std::uint8_t> free = {}; ///< for each turn of the disc

  bool helps() const { return std::find(free.begin(), free.end(), 1) != free.end(); }
};

SmoothRetilt::SmoothRetilt(const LocationGround& ground, const HolderProfile& holder, double most, double step)
: ground_(ground), holder_(holder), disc_(most, disc_rings), step_(step),
  stride_(static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(2.0) * disc_.spacing() / step - rounding)))),
  ramp_(static_cast<std::size_t>(std::ceil(most / step)) + stride_)
{}

SmoothRetilt::Place
SmoothRetilt::placeOf(const DrivePoint& drive, const ToolLocation& location, const Place* before) const
{
  const Eigen::Vector3d axis = drive.axis.normalized();
  Place place{drive, before ? before->frame.movedTo(axis) : AxisWithSides(axis)};
  place.asks = drive.asksForContact();
  if (!place.asks)
    place.contact = {location.contact, axis, location.normal};
  place.slack = ground_.slackAt(place.contact);
  place.wants = isWanting(location) && !fits(location, place.slack);
  return place;
}

void
SmoothRetilt::run(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const
{
  const auto known = [&](std::size_t i) { return i < count && locations[i].state != LocationState::NoCloud; };
  for (std::size_t begin = 0, end = 0; begin < count; begin = end + 1) {
    end = begin;
    while (known(end))
      ++end;
    piece(drive + begin, end - begin, locations + begin);
  }
}

void
SmoothRetilt::piece(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const
{
  if (std::none_of(locations, locations + count, isWanting))
    return;
  Places places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(placeOf(drive[i], locations[i], i > 0 ? &places.back() : nullptr));
  for (std::size_t i = 0; i < count;) {
    if (!places[i].wants) {
      ++i;
      continue;
    }
    const std::size_t begin = i > ramp_ ? i - ramp_ : 0;
    std::size_t last = i; // that wants to be turned
    for (std::size_t k = i; k < count && k <= last + 2 * ramp_; ++k)
      if (places[k].wants)
        last = k;
    const std::size_t end = std::min(count, last + ramp_ + 1);
    window(&places[begin], end - begin, begin > 0, end < count, locations + begin);
    i = end;
  }
}

void
SmoothRetilt::tryTurns(Place& place) const
{
  const DrivePoint& contact = place.contact;
  place.free.assign(disc_.size(), 1);
  place.free[0] = !place.wants;
  for (std::size_t k = 1; k < disc_.size(); ++k)
    place.free[k] = ground_.clears({contact.position, place.frame.turned(disc_[k]), contact.normal}, place.slack, holder_);
}

/** Of \p turn at station \p s: all places up to the neighbouring stations have to be free with it. */
double
SmoothRetilt::costAt(const Place* places, const std::vector<std::size_t>& stations, std::size_t s, std::size_t turn) const
{
  const std::size_t first = s > 0 ? stations[s - 1] + 1 : stations[s], end = s + 1 < stations.size() ? stations[s + 1] : stations[s] + 1;
  double cost = disc_[turn].squaredNorm();
  for (std::size_t i = first; i < end; ++i)
    cost += places[i].free[turn] ? 0.0 : not_free;
  return cost;
}

/** The turn at each place of the way of least cost through the stations. */
std::vector<Eigen::Vector2d>
SmoothRetilt::bestWay(const Place* places, const std::vector<std::size_t>& stations, bool from_zero, bool to_zero) const
{
  const std::size_t turns = disc_.size();
  std::vector<std::vector<std::uint16_t>> before(stations.size(), std::vector<std::uint16_t>(turns, 0));
  std::vector<double> cost(turns);
  for (std::size_t k = 0; k < turns; ++k)
    cost[k] = costAt(places, stations, 0, k) + (from_zero && k > 0 ? cannot : 0.0);
  for (std::size_t s = 1; s < stations.size(); ++s) {
    const double reach = step_ * static_cast<double>(stations[s] - stations[s - 1]) + rounding;
    std::vector<double> next(turns, std::numeric_limits<double>::max());
    for (std::size_t k = 0; k < turns; ++k) {
      for (std::size_t j = 0; j < turns; ++j) {
        const double change = (disc_[k] - disc_[j]).squaredNorm();
        if (change <= reach * reach && cost[j] + change < next[k]) {
          next[k] = cost[j] + change;
          before[s][k] = static_cast<std::uint16_t>(j);
        }
      }
      next[k] += costAt(places, stations, s, k) + (to_zero && s + 1 == stations.size() && k > 0 ? cannot : 0.0);
    }
    cost = std::move(next);
  }
  std::vector<Eigen::Vector2d> way(stations.back() + 1);
  auto k = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  way[stations.back()] = disc_[k];
  for (std::size_t s = stations.size() - 1; s > 0; --s) {
    const std::size_t from = stations[s - 1], to = stations[s];
    k = before[s][k];
    for (std::size_t i = from; i < to; ++i)
      way[i] = disc_[k] + (way[to] - disc_[k]) * static_cast<double>(i - from) / static_cast<double>(to - from);
  }
  return way;
}

/** Bars the turns next to those that were not free when located. Returns how many places have such. */
std::size_t
SmoothRetilt::bar(Place* places, std::size_t count, const std::vector<Eigen::Vector2d>& turns, const ToolLocations& found) const
{
  std::size_t barred = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (turns[i].isZero(0.0) || fits(found[i], places[i].slack) || !places[i].helps())
      continue;
    ++barred;
    for (std::size_t k = 1; k < disc_.size(); ++k)
      if ((disc_[k] - turns[i]).norm() < disc_.spacing())
        places[i].free[k] = 0;
  }
  return barred;
}

void
SmoothRetilt::window(Place* places, std::size_t count, bool from_zero, bool to_zero, ToolLocation* locations) const
{
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i)
    tryTurns(places[i]);
  std::vector<std::size_t> stations;
  for (std::size_t i = 0; i < count; i += stride_)
    stations.push_back(i);
  if (stations.back() != count - 1)
    stations.push_back(count - 1);
  std::vector<Eigen::Vector2d> turns;
  ToolLocations found(count);
  for (int round = 0; round < most_turnings; ++round) {
    turns = bestWay(places, stations, from_zero, to_zero);
    DrivePoints turned;
    for (std::size_t i = 0; i < count; ++i)
      turned.push_back({places[i].contact.position, places[i].frame.turned(turns[i]), places[i].contact.normal});
    ground_.locate(turned.data(), count, found.data());
    if (bar(places, count, turns, found) == 0)
      break;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (turns[i].isZero(0.0) || found[i].state == LocationState::NoCloud)
      continue;
    found[i].retilt = turns[i].norm() / degree;
    if (!places[i].asks && found[i].lift <= places[i].slack) {
      found[i].state = LocationState::Touching;
      found[i].lift = 0.0;
    }
    locations[i] = found[i];
  }
}

} // namespace pcl_spiral
