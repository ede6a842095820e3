// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_ground.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/impl/holder_collision.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double least_share = 0.2; // of the normal along the axis: lower limit when noise along the normal is converted to the axis

} // namespace

CloudGround::CloudGround(const LocationSurface& surface, const CutterProfile& profile, const LocationOptions& options)
: surface_(surface), options_(options), profile_(profile), drop_(surface.obstacles(), profile, options.ceiling),
  rim_drop_(surface.rim(), profile, options.ceiling), inner_drop_(surface.obstacles(), insetCutter(profile, near()), options.ceiling),
  fitted_drop_(surface, profile, options.ceiling), holder_(options.holder, profile.topHeight(), profile.radius(), options.holder_clearance),
  above_(profile, options)
{}

bool
CloudGround::trusted(const FittedContact& fitted, const DropContact& drop) const
{
  if (!fitted.found)
    return false;
  const double noise = surface_.noiseAllowance() / std::max(least_share, fitted.normal_share);
  const double sunk = fitted.height - drop.height;
  const double most = std::min(fitted.gap_bound, profile_.radius());
  return sunk > -noise && sunk < most + noise;
}

DropContact
CloudGround::onEdge(const AxisFrame& frame, const FittedContact& fitted, const DropContact& drop) const
{
  constexpr double most = 2.0; // spacings from outermost points, which are ragged, down a slope of 45 degrees to the edge
  if (!fitted.beyond)
    return {};
  const double noise = surface_.noiseAllowance() / least_share, spacing = surface_.surface().graph().spacing();
  DropContact edge = CutterDrop(surface_.edge(), profile_, options_.ceiling).highest(frame, drop.height - noise);
  edge.found = edge.found && edge.height < drop.height + most * spacing + noise;
  return edge;
}

void
CloudGround::settle(const AskedLocation& asked, double height, ToolLocation& location) const
{
  height = asked.settle(height, options_.tolerance, location);
  location.tip = asked.frame.place(Eigen::Vector2d::Zero(), height);
  asked.settleContact(profile_, height, location);
  asked.findRim(rim_drop_, profile_.radius(), height, location);
  location.collision = findCollision(surface_.obstacles(), holder_, asked.frame, height, options_.tolerance);
  const auto find = [&](const HolderProfile& tool) {
    return findCollision(surface_.obstacles(), tool, asked.frame, height, options_.tolerance, options_.ceiling);
  };
  above_.look(find, location);
  location.collision.cloud_index = surface_.cloudIndex(location.collision.cloud_index);
}

void
CloudGround::standOn(const AskedLocation& asked, const SurfaceFoot& foot, ToolLocation& location) const
{
  const double side = foot.normal.dot(asked.frame.axis) < 0.0 ? -1.0 : 1.0;
  const double above = side * (asked.position - foot.position).dot(foot.normal);
  const double share = side * foot.normal.dot(asked.frame.axis);
  if (std::abs(above) > near() && share < steep_share)
    return;
  location.cloud_index = surface_.cloudIndexOnSurface(foot.nearest);
  location.contact = foot.position;
  location.normal = side * foot.normal;
  location.basis = LocationBasis::AskedContact;
  location.gap_bound = std::numeric_limits<double>::infinity();
  settle(asked, std::abs(above) > near() ? -above / share : 0.0, location);
}

ToolLocation
CloudGround::resolve(const AskedLocation& asked, const DropContact& drop, const FittedContact& fitted, const SurfaceFoot& foot) const
{
  ToolLocation location;
  location.axis = asked.frame.axis;
  if (!drop.found) {
    if (asked.asks && asked.contact.touches && surface_.hasSurface() && surface_.covers(foot))
      standOn(asked, foot, location);
    return location;
  }
  location.cloud_index = surface_.cloudIndex(drop_.blocks().originalIndex(drop.point));
  location.contact = drop_.blocks().position(drop.point);
  double height = drop.height;
  if (trusted(fitted, drop)) {
    location.basis = LocationBasis::FittedSurface;
    location.contact = fitted.contact;
    location.normal = fitted.normal;
    location.gap_bound = fitted.gap_bound;
    location.gap = fitted.height - drop.height;
    height = fitted.height;
  }
  else if (const DropContact edge = onEdge(asked.frame, fitted, drop); edge.found) {
    location.basis = LocationBasis::FittedSurface;
    location.contact = surface_.edge().position(edge.point);
    location.gap = edge.height - drop.height;
    height = edge.height;
  }
  else {
    location.gap_bound = foot.valid ? fitted_drop_.gapBound(asked.frame, foot) : std::numeric_limits<double>::infinity();
    if (options_.evaluation != LocationEvaluation::Points && std::isfinite(location.gap_bound)) {
      location.basis = LocationBasis::PointsAndBound;
      location.gap = location.gap_bound;
      height += location.gap_bound;
    }
  }
  if (height > options_.tolerance && asked.holds(inner_drop_, near())) {
    location.basis = LocationBasis::AskedContact;
    location.contact = asked.position;
    location.gap = height = 0.0;
  }
  settle(asked, height, location);
  return location;
}

void
CloudGround::locate(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const
{
  std::vector<AskedLocation> asked;
  std::vector<AxisFrame> frames;
  std::vector<DropContact> drops(count);
  for (std::size_t i = 0; i < count; ++i) {
    asked.emplace_back(drive[i], profile_);
    frames.push_back(asked.back().frame);
  }
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i)
    drops[i] = drop_.highest(frames[i]);
  std::vector<FittedContact> fitted(count);
  if (options_.evaluation == LocationEvaluation::FittedSurface)
    fitted_drop_.locate(frames, drops, fitted);
  std::vector<SurfaceFoot> feet(count);
  if (surface_.hasSurface()) { // if the points decide, the surface about them limits how far a cutter may sink
    std::vector<std::uint32_t> which;
    std::vector<Eigen::Vector3d> queries;
    std::vector<SurfaceFoot> found;
    for (std::size_t i = 0; i < count; ++i)
      if (!drops[i].found ? asked[i].asks : !trusted(fitted[i], drops[i])) {
        which.push_back(static_cast<std::uint32_t>(i));
        queries.push_back(drops[i].found ? drop_.blocks().position(drops[i].point) : asked[i].position);
      }
    surface_.surface().project(queries, found);
    for (std::size_t k = 0; k < which.size(); ++k)
      feet[which[k]] = found[k];
  }
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i)
    locations[i] = resolve(asked[i], drops[i], fitted[i], feet[i]);
}

bool
CloudGround::clears(const DrivePoint& drive, double slack, const HolderProfile& holder) const
{
  const AskedLocation asked(drive, profile_);
  const bool clear = !drop_.highest(asked.frame, slack).found || asked.holds(inner_drop_, near());
  return asked.contact.touches && clear && !findCollision(surface_.obstacles(), holder, asked.frame, 0.0, options_.tolerance).found();
}

double
CloudGround::slackAt(const DrivePoint& drive) const
{
  return near() / std::max(least_share, drive.normal.normalized().dot(drive.axis.normalized()));
}

Status
CloudGround::check() const
{
  if (options_.evaluation != LocationEvaluation::Points && !surface_.hasSurface())
    return {surface_.whyNone().code(), Diagnostic(surface_.whyNone().diagnostic(),
                                                  "; without a surface, cutters can be located only on the points (as "
                                                  "{LocationEvaluation::Points}), with no limit on how far they sink between the points")};
  return Status::success();
}

double
CloudGround::moveError(const CutterPlace& from, const CutterPlace& to, double) const
{
  return sweptError(profile_, from, to);
}

void
CloudGround::describe(const ToolLocations&, LocationReport& f) const
{
  f.noise_allowance = surface_.noiseAllowance();
  f.outlier_points = surface_.hasSurface() ? surface_.outlierPoints() : 0;
  const std::size_t asked = f.count(LocationState::Reached) + f.count(LocationState::Lifted) + f.count(LocationState::Clear);
  if (asked > 0 && surface_.hasSurface() && surface_.surface().fitNoise() > options_.tolerance)
    f.warnings.push_back(
        Diagnostic("because of noise the surface of the scan is known to only ", surface_.surface().fitNoise(),
                   " {mm}, more than the contact tolerance of ", options_.tolerance,
                   " {mm}: contacts may be reported as lifted or clear only because of noise; raise the tolerance to three times "
                   "this error"));
  if (f.outlier_points > 0)
    f.warnings.push_back(Diagnostic(f.outlier_points, " points of the scan are outliers; the cutter stays clear of "
                                                      "them too: remove them first if they are false echoes ({OutlierRemoval})"));
  if (!surface_.hasSurface())
    f.warnings.push_back(Diagnostic("the points form no surface, so the rim of the scan is not known: ", surface_.whyNone().diagnostic()));
}

} // namespace pcl_spiral
