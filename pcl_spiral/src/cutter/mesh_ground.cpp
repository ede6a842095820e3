// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_ground.h"

#include "mesh_collision.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double finest = 5e-4;        // mm: faces this near to the curved surface are used instead of it
constexpr double fine_share = 0.05;    // the same, of the tolerance
constexpr double same_axis = 1e-9;     // between unit axes
constexpr double expected_share = 2.0; // of the tolerance, below the drive point

double
sagFor(const LocationOptions& options)
{
  if (options.evaluation == LocationEvaluation::Points)
    return std::numeric_limits<double>::infinity();
  return std::min(finest, fine_share * options.tolerance);
}

} // namespace

MeshGround::MeshGround(const LocationMesh& mesh, const CutterProfile& profile, const LocationOptions& options)
: mesh_(mesh), options_(options), profile_(profile), sag_(sagFor(options)), drop_(mesh.faces(), profile, sag_, options.ceiling),
  rim_drop_(mesh.rim(), profile, sag_, options.ceiling), inner_drop_(mesh.faces(), insetCutter(profile, near()), sag_, options.ceiling),
  sweep_(mesh.faces(), profile.radius(), sag_), holder_(options.holder, profile.topHeight(), profile.radius(), options.holder_clearance),
  above_(profile, options)
{}

Status
MeshGround::check() const
{
  if (options_.evaluation == LocationEvaluation::PointsAndBound)
    return {StatusCode::InvalidArgument,
            "locations by points and bound were set for a mesh, which has no gaps between points: set the evaluation to "
            "{LocationEvaluation::FittedSurface}, for the curved surface, or to Points, for the faces as they are ({setEvaluation})"};
  return Status::success();
}

void
MeshGround::touch(std::uint32_t face, const Eigen::Vector3d& weights, const Eigen::Vector3d& contact, ToolLocation& location) const
{
  const Eigen::Vector3d normal = std::isfinite(sag_) ? mesh_.mesh()->patch(face).normal(weights) : mesh_.mesh()->faceNormal(face);
  location.cloud_index = face;
  location.contact = contact;
  location.normal = normal.dot(location.axis) < 0.0 ? Eigen::Vector3d(-normal) : normal;
  location.basis = std::isfinite(sag_) ? LocationBasis::FittedSurface : LocationBasis::Points;
}

bool
MeshGround::findAsked(const AskedLocation& asked, PatchPlace& place) const
{
  return asked.asks && asked.contact.touches && mesh_.faces().nearest(asked.position, near(), sag_, place);
}

void
MeshGround::settle(const AskedLocation& asked, double height, ToolLocation& location) const
{
  height = asked.settle(height, options_.tolerance, location);
  location.tip = asked.frame.place(Eigen::Vector2d::Zero(), height);
  asked.settleContact(profile_, height, location);
  asked.findRim(rim_drop_, profile_.radius(), height, location);
  location.collision = findCollision(mesh_.faces(), holder_, asked.frame, height, options_.tolerance, sag_);
  const auto find = [&](const HolderProfile& tool) {
    return findCollision(mesh_.faces(), tool, asked.frame, height, options_.tolerance, sag_, options_.ceiling);
  };
  above_.look(find, location);
}

/** Drive points lie on the surface, or between locations on it: lower parts are searched only if nothing is met. */
MeshContact
MeshGround::highest(const AxisFrame& frame) const
{
  const MeshContact near = drop_.highest(frame, -expected_share * options_.tolerance);
  return near.found ? near : drop_.highest(frame);
}

ToolLocation
MeshGround::resolve(const AskedLocation& asked) const
{
  ToolLocation location;
  location.axis = asked.frame.axis;
  const MeshContact drop = highest(asked.frame);
  if (drop.found)
    touch(drop.face, drop.weights, drop.contact, location);
  double height = drop.height;
  const bool missed = !drop.found || (asked.isSteep() && height < -options_.tolerance); // it touches a flank beside it, by rounding
  PatchPlace place;
  if (missed && findAsked(asked, place)) {
    touch(place.patch, place.weights, place.position, location);
    location.basis = LocationBasis::AskedContact;
    height = 0.0;
  }
  else if (!drop.found)
    return location;
  else if (height > options_.tolerance && asked.holds(inner_drop_, near())) {
    if (findAsked(asked, place))
      touch(place.patch, place.weights, place.position, location);
    location.basis = LocationBasis::AskedContact;
    location.contact = asked.position;
    height = 0.0;
  }
  settle(asked, height, location);
  return location;
}

void
MeshGround::locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const
{
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i)
    locations[i] = resolve(AskedLocation(drive[i], profile_));
}

bool
MeshGround::clears(const DrivePoint& drive, double slack, const HolderProfile& holder) const
{
  const AskedLocation asked(drive, profile_);
  const bool clear = !drop_.highest(asked.frame, slack).found || asked.holds(inner_drop_, near());
  return asked.contact.touches && clear && !findCollision(mesh_.faces(), holder, asked.frame, 0.0, options_.tolerance, sag_).found();
}

double
MeshGround::slackAt(const DrivePoint&) const
{
  return options_.tolerance;
}

double
MeshGround::moveError(const CutterPlace& from, const CutterPlace& to, double allowed) const
{
  const double swept = sweptError(profile_, from, to), off = std::isfinite(sag_) ? sag_ : 0.0, R = profile_.radius();
  const bool ball = profile_.cornerRadius() == R && profile_.flankAngle() == 0.0;
  if (swept <= allowed || allowed <= off || !ball || (to.axis - from.axis).norm() > same_axis)
    return swept;
  const Eigen::Vector3d start = from.tip + R * from.axis, end = to.tip + R * to.axis;
  if (const double depth = sweep_.depth(start, end, from.axis, allowed - off); depth > allowed - off)
    return std::min(swept, depth + off);
  return sweep_.touches(start, end, from.axis, allowed) ? allowed : swept;
}

void
MeshGround::describe(const ToolLocations& locations, LocationReport& f) const
{
  f.noise_allowance = mesh_.rounding() + (std::isfinite(sag_) ? sag_ : 0.0);
  const auto lift = [](const ToolLocation& l) { return l.state == LocationState::Lifted ? l.lift : 0.0; };
  const auto most =
      std::max_element(locations.begin(), locations.end(), [&](const ToolLocation& a, const ToolLocation& b) { return lift(a) < lift(b); });
  if (const std::size_t lifted = f.count(LocationState::Lifted); lifted > 0)
    f.warnings.push_back(Diagnostic(lifted, " of ", locations.size(), " locations are lifted off their given contact, the most by ",
                                    most->lift, " {mm}: location ", most - locations.begin(), ", held at ", Place(most->contact),
                                    "; material is left there: use a smaller cutter, or allow the axis to be tilted"));
}

} // namespace pcl_spiral
