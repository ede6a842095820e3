// SPDX-License-Identifier: BSD-3-Clause
#include "location_ground.h"
#include "smooth_retilt.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int rings = 6, around = 12;
constexpr int most_fit_rounds = 6; // of axes that clear the points but not the fitted surface

/** Axes about \p axis, the least tilt first; axes with the same tilt start with those nearest to \p away. */
class ConeOfAxes {
public:
  ConeOfAxes(const Eigen::Vector3d& axis, const Eigen::Vector3d& away, double angle) : axis_(axis), angle_(angle)
  {
    const Eigen::Vector3d across = away - away.dot(axis) * axis;
    Eigen::Vector3d e1, e2;
    tangentFrame(axis, e1, e2);
    first_ = across.norm() > 1e-9 ? Eigen::Vector3d(across.normalized()) : e1;
    second_ = axis.cross(first_);
  }
  static constexpr int size = rings * around;

  double tilt(int i) const
  {
    const int ring = i / around + 1;
    return angle_ * ring / rings;
  }
  Eigen::Vector3d operator[](int i) const
  {
    const int turn = (i % around + 1) / 2 * (i % 2 == 0 ? 1 : -1); // 0, then alternately to either side
    const double azimuth = 2.0 * pi * turn / around;
    const Eigen::Vector3d side = std::cos(azimuth) * first_ + std::sin(azimuth) * second_;
    return std::cos(tilt(i)) * axis_ + std::sin(tilt(i)) * side;
  }

private:
  Eigen::Vector3d axis_, first_, second_;
  double angle_;
};

} // namespace

bool
isWanting(const ToolLocation& location)
{
  return location.state == LocationState::Lifted || location.state == LocationState::Unreachable || location.collision.found();
}

HolderProfile
CutterLocationEngine::holderWith(double margin) const
{
  return HolderProfile(options_.holder, profile_.topHeight(), profile_.radius(), options_.holder_clearance + margin);
}

void
CutterLocationEngine::retiltPass(const DrivePoint* drive, double margin, std::size_t count, ToolLocation* locations) const
{
  SmoothRetilt(*ground_, holderWith(margin), options_.max_retilt * degree, options_.retilt_step * degree).run(drive, count, locations);
}

void
CutterLocationEngine::retilt(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const
{
  struct Pending {
    std::size_t index;
    ConeOfAxes cone;
    int next = 0;
  };
  const HolderProfile holder = holderWith(0.0);
  std::vector<Pending> pending;
  for (std::size_t i = 0; i < count; ++i)
    if (drive[i].asksForContact() && isWanting(locations[i])) {
      const Eigen::Vector3d met = locations[i].collision.found() ? locations[i].collision.place : locations[i].contact;
      const Eigen::Vector3d away =
          locations[i].state == LocationState::Unreachable ? drive[i].normal : Eigen::Vector3d(locations[i].tip - met);
      pending.push_back({i, ConeOfAxes(locations[i].axis, away, options_.max_retilt * degree)});
    }
  for (int round = 0; round < most_fit_rounds && !pending.empty(); ++round) {
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(pending.size()); ++k) {
      Pending& p = pending[k];
      const DrivePoint& asked = drive[p.index];
      while (p.next < ConeOfAxes::size && !ground_->clears({asked.position, p.cone[p.next], asked.normal}, options_.tolerance, holder))
        ++p.next;
    }
    const auto none_left = [](const Pending& p) { return p.next == ConeOfAxes::size; };
    pending.erase(std::remove_if(pending.begin(), pending.end(), none_left), pending.end());
    DrivePoints tilted;
    for (const Pending& p : pending)
      tilted.push_back({drive[p.index].position, p.cone[p.next], drive[p.index].normal});
    ToolLocations found(tilted.size());
    ground_->locate(tilted.data(), tilted.size(), found.data());
    std::vector<Pending> left;
    for (std::size_t k = 0; k < pending.size(); ++k) {
      Pending& p = pending[k];
      if (found[k].state != LocationState::Reached || found[k].collision.found()) {
        ++p.next;
        left.push_back(p);
        continue;
      }
      found[k].retilt = p.cone.tilt(p.next) / degree;
      locations[p.index] = found[k];
    }
    pending = std::move(left);
  }
}

} // namespace pcl_spiral
