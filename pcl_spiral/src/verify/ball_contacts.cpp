// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/cutter_contacts.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>

#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr int rounds = 4; // each brings the foot nearer by the misfit of a quadric

/** The contact by the quadric about \p foot. */
NearestContact
contactBy(const SurfaceFoot& foot, const Eigen::Vector3d& centre, double radius, double reach)
{
  NearestContact contact;
  const SurfaceHeight nearest = heightAbove(foot, centre, reach);
  const Eigen::Vector3d way = centre - nearest.place;
  contact.normal = way.norm() > 1e-6 ? Eigen::Vector3d(std::copysign(1.0, nearest.height) * way.normalized()) : foot.normal;
  contact.position = centre - radius * contact.normal;
  contact.height = nearest.height - radius;
  contact.valid = true;
  return contact;
}

} // namespace

std::vector<NearestContact>
ballContacts(const ReferenceSurface& reference, const std::vector<Eigen::Vector3d>& centres, double radius)
{
  const PointBlocks& points = reference.graph().blocks();
  const double reach = 2.0 * reference.fitRadius();
  std::vector<Eigen::Vector3d> queries(centres.size());
  std::vector<SurfaceFoot> feet;
  std::vector<NearestContact> contacts(centres.size());
  const auto size = static_cast<std::int64_t>(centres.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < size; ++i)
    queries[i] = points.position(points.nearest(centres[i]));
  for (int round = 0; round < rounds; ++round) {
    reference.surface().project(queries, feet);
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < size; ++i)
      if (feet[i].valid) { // else the contact of the round before stays
        contacts[i] = contactBy(feet[i], centres[i], radius, reach);
        queries[i] = contacts[i].position - contacts[i].height * contacts[i].normal;
      }
  }
  return contacts;
}

} // namespace pcl_spiral
