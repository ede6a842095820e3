// SPDX-License-Identifier: BSD-3-Clause
#include "lowest_over.h"
#include <pcl_spiral/verify/impl/cutter_contacts.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr int contact_rounds = 3; // each brings the place nearer by the misfit of a quadric

/** The scan point that is deepest in the cutter, or nearest to it. */
Eigen::Vector3d
deepestPoint(const PointBlocks& points, const ProfileDepth& profile, double corner, const CutterPlace& place)
{
  const auto depth = [&](const Eigen::Vector3d& p) { return profile.at(p, place.tip, place.axis); };
  Eigen::Vector3d best = points.position(points.nearest(place.tip + corner * place.axis));
  double most = depth(best);
  const auto may_hold = [&](const Box& box) { // depth changes by at most the way
    const Eigen::Vector3d middle(0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0.5 * (box.low[2] + box.high[2]));
    return depth(middle) + 0.5 * box.diagonal() > most;
  };
  points.forBlocks(may_hold, [&](std::size_t block) {
    for (std::size_t i = points.blockBegin(block); i < points.blockEnd(block); ++i)
      if (const double here = depth(points.position(i)); here > most) {
        most = here;
        best = points.position(i);
      }
  });
  return best;
}

} // namespace

std::vector<NearestContact>
cutterContacts(const ReferenceSurface& reference, const std::vector<CutterPlace>& places, const CutterShape& cutter)
{
  if (isBall(cutter)) {
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(places.size());
    for (const CutterPlace& place : places)
      centres.push_back(place.tip + cutter.radius * place.axis);
    return ballContacts(reference, centres, cutter.radius);
  }
  const ProfileDepth profile{CutterProfile(cutter)};
  const PointBlocks& points = reference.graph().blocks();
  const double reach = 2.0 * reference.fitRadius();
  std::vector<Eigen::Vector3d> queries(places.size());
  std::vector<SurfaceFoot> feet;
  std::vector<NearestContact> contacts(places.size());
  const auto size = static_cast<std::int64_t>(places.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < size; ++i)
    queries[i] = deepestPoint(points, profile, cutter.corner_radius, places[i]);
  for (int round = 0; round <= contact_rounds; ++round) {
    reference.surface().project(queries, feet);
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < size; ++i)
      if (feet[i].valid) { // else the contact of the round before stays
        const SurfaceHeight lowest = lowestOver(profile, places[i].tip, places[i].axis, feet[i], round < contact_rounds ? reach : 0.0);
        contacts[i] = {lowest.place + lowest.height * feet[i].normal, feet[i].normal, lowest.height, true};
        queries[i] = lowest.place;
      }
  }
  return contacts;
}

} // namespace pcl_spiral
