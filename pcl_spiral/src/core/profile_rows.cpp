// SPDX-License-Identifier: BSD-3-Clause
#include "profile_rows.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int near_angles = 24, far_angles = 24, halvings = 40;
constexpr double smallest_angle = 1e-7;

/** Angles from the contact to one side: dense where the cutter stands lower than \p height above the plane, then evenly to 90 degrees. */
std::vector<double>
anglesOf(double corner, double height)
{
  const double dense = std::min(0.25 * pi, 2.0 * std::sqrt(2.0 * height / std::max(corner, height)));
  std::vector<double> angles{smallest_angle};
  for (int k = 1; k <= near_angles; ++k)
    angles.push_back(dense * k / near_angles);
  for (int k = 1; k < far_angles; ++k)
    angles.push_back(dense + (0.5 * pi - dense) * k / far_angles);
  return angles;
}

enum class Fit { Gouges, Keeps, Leaves }; // against the height, at the place between two rows

/** The distance of the next row on one side. */
struct RowReach {
  double distance = 0.0;
  bool gouges = false; ///< farther off, the cutter would cut into the place by more than the height
};

/** A cutter on a paraboloid, with its contact beside the place. Lengths from the place. */
class BesidePlace {
public:
  BesidePlace(const SurfaceBend& place, const CutterProfile& profile, const Vector3d& axis, double height, RowsThrough through)
  : place_(place), second_(place.normal.cross(place.direction1)), profile_(profile), axis_(axis), height_(height), through_(through)
  {}

  RowReach reach(const Vector3d& across, const Vector3d& w) const
  {
    const Vector3d start = tipAt(Vector3d::Zero(), place_.normal);
    Vector3d last = Vector3d::Zero();
    for (const Vector3d& contact : contactsAlong(w)) {
      const Fit fit = fitAt(contact);
      if (fit != Fit::Keeps) {
        const Vector3d farthest = last + lastKept(last, contact) * (contact - last);
        return {std::abs(across.dot(tipAt(farthest, normalAt(farthest)) - start)), fit == Fit::Gouges};
      }
      last = contact;
    }
    return {std::abs(across.dot(tipAt(last, normalAt(last)) - start)), false};
  }

private:
  Vector3d bend(const Vector3d& e) const
  {
    return place_.curvature1 * place_.direction1.dot(e) * place_.direction1 + place_.curvature2 * second_.dot(e) * second_;
  }
  Vector3d normalAt(const Vector3d& e) const { return (place_.normal + bend(e)).normalized(); }
  Vector3d axisAt(const Vector3d& normal) const { return through_ == RowsThrough::Centres ? axis_ : normal; }
  Vector3d tipAt(const Vector3d& e, const Vector3d& normal) const
  {
    return profile_.locate(e - 0.5 * e.dot(bend(e)) * place_.normal, normal, axisAt(normal)).tip;
  }

  Fit fitAt(const Vector3d& contact) const
  {
    const Vector3d normal = normalAt(contact), axis = axisAt(normal), tip = tipAt(contact, normal);
    const auto isCut = [&](double above) {
      const Vector3d x = above * place_.normal - tip;
      const double z = x.dot(axis);
      return profile_.contains((x - z * axis).norm(), z);
    };
    return isCut(-height_) ? Fit::Gouges : isCut(height_) ? Fit::Keeps : Fit::Leaves;
  }

  /** Contacts from which the cutter, on a plane, cuts nearest to the place: those of its places with normals from the surface's
   *  to -\p w, and up the shank. */
  std::vector<Vector3d> contactsAlong(const Vector3d& w) const
  {
    const Vector3d& n = place_.normal;
    const Vector3d axis = axisAt(n), middle = profile_.locate(Vector3d::Zero(), n, axis).tip;
    const auto inPlane = [&](const Vector3d& x) { return Vector3d(x - x.dot(n) * n); };
    std::vector<Vector3d> contacts;
    for (const double angle : anglesOf(profile_.cornerRadius(), height_)) {
      const CutterContact touch = profile_.locate(Vector3d::Zero(), std::cos(angle) * n + std::sin(angle) * w, axis);
      if (!touch.touches)
        break;
      contacts.push_back(inPlane(touch.tip - middle));
    }
    if (axis.dot(w) < 0.0)
      contacts.push_back((contacts.empty() ? Vector3d(Vector3d::Zero()) : contacts.back()) - 2.0 * profile_.radius() * inPlane(axis));
    return contacts;
  }

  /** Share of the way between two contacts up to where the height is kept. */
  double lastKept(const Vector3d& from, const Vector3d& to) const
  {
    double low = 0.0, high = 1.0;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (low + high);
      (fitAt(from + middle * (to - from)) == Fit::Keeps ? low : high) = middle;
    }
    return low;
  }

  SurfaceBend place_;
  Vector3d second_;
  const CutterProfile& profile_;
  Vector3d axis_;
  double height_;
  RowsThrough through_;
};

} // namespace

double
profileRowDistance(const SurfaceBend& place, const Vector3d& across, const CutterProfile& profile, const Vector3d& axis, double height,
                   RowsThrough through, double flattest)
{
  const Vector3d along = place.normal.cross(across);
  const double lean = along.norm();
  if (!(lean > 0.0))
    return 0.0;
  const bool centres = through == RowsThrough::Centres;
  if (centres && !profile.locate(Vector3d::Zero(), place.normal, axis).touches)
    return std::numeric_limits<double>::infinity();
  SurfaceBend seen = place;
  for (double* const curvature : {&seen.curvature1, &seen.curvature2})
    if (*curvature < 0.0 && *curvature > -flattest)
      *curvature = 0.0;
  const Vector3d w = along.cross(place.normal) / lean;
  const BesidePlace beside(seen, profile, axis, height, through);
  const RowReach first = beside.reach(across, w), second = beside.reach(across, -w);
  const double distance = first.distance + second.distance;
  if (!centres || !(first.gouges || second.gouges))
    return distance;
  return std::min(distance, rowDistance(seen, across, std::max(profile.cornerRadius(), height), height, through));
}

} // namespace pcl_spiral
