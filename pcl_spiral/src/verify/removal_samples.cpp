// SPDX-License-Identifier: BSD-3-Clause
#include "removal_samples.h"

#include <pcl_spiral/core/step_over.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr double hollowest = -0.9;     // of 1/R: beyond it the ball hardly fits and step-overs have no meaning
constexpr double farthest_ridge = 2.0; // in step-overs: a missing turn is one step-over away
constexpr double walk = 0.7;           // in step-overs: goes beyond the ridge of a pass at its place
constexpr double shallow_start = 0.2;  // in scallop heights, at least: where a short ray starts below the surface

} // namespace

void
RemovalExtremes::merge(const RemovalExtremes& later)
{
  raise(stock, later.stock.value, later.stock.position, later.stock.index);
  raise(scallop, later.scallop.value, later.scallop.position, later.scallop.index);
  raise(rim, later.rim.value, later.rim.position, later.rim.index);
  raise(gouge, later.gouge.value, later.gouge.position, later.gouge.index);
  raise(unreached, later.unreached.value, later.unreached.position, later.unreached.index);
  raise(crease, later.crease.value, later.crease.position, later.crease.index);
  raise(crease_gouge, later.crease_gouge.value, later.crease_gouge.position, later.crease_gouge.index);
  raise(rim_gouge, later.rim_gouge.value, later.rim_gouge.position, later.rim_gouge.index);
  raise(face_depth, later.face_depth.value, later.face_depth.position, later.face_depth.index);
  raise(face_gouge, later.face_gouge.value, later.face_gouge.position, later.face_gouge.index);
}

RemovalSampler::RemovalSampler(const ReferenceSurface& reference, const CutterSweep& sweep, const RemovalSettings& settings, double reach,
                               const BallReach* ball)
: reference_(reference), sweep_(sweep), settings_(settings), ball_(ball),
  step_radius_(settings.step_radius > 0.0 ? settings.step_radius : settings.tool_radius),
  field_(sweep, std::max(shallow_start * settings.scallop_height, settings.chord_error), reach), fit_radius_(reference.fitRadius())
{}

double
RemovalSampler::largestStep(const SurfaceFoot& foot) const
{
  const double curvature = std::clamp(foot.curvature2, hollowest / step_radius_, 1.0 / settings_.scallop_height);
  return stepOver(step_radius_, curvature, settings_.scallop_height).value_or(0.0);
}

double
RemovalSampler::stepAcross(const SurfaceFoot& foot, const Eigen::Vector3d& w) const
{
  const double curvature = std::clamp(foot.normalCurvature(w), hollowest / step_radius_, 1.0 / settings_.scallop_height);
  return stepOver(step_radius_, curvature, settings_.scallop_height).value_or(0.0);
}

Zone
RemovalSampler::zoneOf(const SurfaceFoot& foot, const Eigen::Vector3d& position, double step) const
{
  if (reference_.inCreaseBand(position))
    return Zone::Crease;
  if (ball_ && (ball_->isNearUnreached(position, reference_.graph().spacing()) ||
                ball_->isNearObstacle(position + ball_->radius() * foot.normal, ball_->radius() + step))) // a turn beside it may be lifted
    return Zone::Unreached;
  return foot.overhang > 0.0 || reference_.rimDistance(position, step) < step ? Zone::Rim : Zone::Main;
}

void
RemovalSampler::takeRidge(const SurfaceFoot& foot, const Ridge& ridge, double step, RemovalExtremes& extremes, float* height) const
{
  if (!ridge.found || zoneOf(foot, ridge.position, step) != Zone::Main || reference_.inGap(ridge.position))
    return;
  raise(extremes.scallop, ridge.height, ridge.position, ridge.move);
  if (height)
    *height = static_cast<float>(ridge.height);
}

/** Whether the ray from a foot into the material may leave the part within \p depth: under the rim, or through a ridge. */
bool
RemovalSampler::leavesPart(const SurfaceFoot& foot, double depth) const
{
  constexpr double shorter = 0.9; // way to the nearest point: the surface bends at least that little
  if (foot.overhang > 0.0 || reference_.outermostDistance(foot.position, depth) < depth)
    return true;
  if (depth < reference_.graph().spacing())
    return false;
  const PointBlocks& points = reference_.graph().blocks();
  const Eigen::Vector3d end = foot.position - depth * foot.normal;
  return (points.position(points.nearest(end)) - end).norm() < shorter * depth;
}

/** Whether the ray from a foot down to \p depth runs beside the middles of the balls that it meets: then it follows their way, or a fit is
 *  wrong, as at edges that a coarse scan misses. Down to a middle, some place of it is as deep as half its length. */
bool
RemovalSampler::grazesBall(const SurfaceFoot& foot, double depth) const
{
  constexpr int places = 8;
  constexpr double share = 0.4; // of the depth
  for (int i = 0; i <= places; ++i)
    if (sweep_.deepest(foot.position - depth * i / places * foot.normal) >= share * depth)
      return false;
  return true;
}

Stock
RemovalSampler::stockAt(const SurfaceFoot& foot, std::size_t guess) const
{
  Stock stock = field_.at(foot.position, foot.normal, guess);
  const double along_ray = -stock.height;
  if (along_ray > std::max(shallow_start * settings_.scallop_height, settings_.chord_error) &&
      (leavesPart(foot, along_ray) || (!settings_.corner_radius && grazesBall(foot, along_ray))))
    stock.height = -std::min(along_ray, sweep_.deepest(foot.position));
  return stock;
}

SampleResult
RemovalSampler::at(const SurfaceFoot& foot, std::size_t& guess, RemovalExtremes& extremes) const
{
  SampleResult result;
  result.stock = result.ridge = none;
  if (!foot.valid)
    return result;
  const double largest = largestStep(foot);
  const Stock stock = stockAt(foot, guess);
  result.zone = zoneOf(foot, foot.position, largest);
  result.met = stock.met;
  result.move = stock.move;
  result.stock = static_cast<float>(stock.height);
  result.step = static_cast<float>(largest);
  if (stock.met)
    guess = stock.move;
  const bool crease = result.zone == Zone::Crease;
  raise(crease ? extremes.crease_gouge : extremes.gouge, -stock.height, foot.position, stock.move);
  PlacedValue& most = crease                           ? extremes.crease
                      : result.zone == Zone::Unreached ? extremes.unreached
                      : result.zone == Zone::Rim       ? extremes.rim
                                                       : extremes.stock;
  raise(most, stock.height, foot.position, stock.move);
  if (!stock.met || result.zone != Zone::Main)
    return result;
  const double step = stepAcross(foot, field_.across(foot, stock.move));
  const double limit = std::min(farthest_ridge * step, std::max(fit_radius_, 0.25 * step));
  takeRidge(foot, field_.climbed(foot, stock, walk * step, limit), largest, extremes, &result.ridge);
  return result;
}

void
RemovalSampler::inFace(std::size_t i, std::size_t move, RemovalExtremes& extremes) const
{
  const ReferenceMesh& mesh = *reference_.mesh();
  const std::size_t sample = reference_.scanned().sourceIndex(i);
  const Eigen::Vector3d place = mesh.flatPlace(sample);
  if (reference_.inCreaseBand(place))
    return;
  const double depth = sweep_.deepest(place);
  raise(extremes.face_depth, depth, place, move);
  raise(extremes.face_gouge, depth - bendDepth(mesh.mesh(), mesh.sampleFaces()[sample]), place, move);
}

void
RemovalSampler::beside(const SurfaceFoot& foot, std::size_t move, double side, RemovalExtremes& extremes) const
{
  const double largest = largestStep(foot);
  if (fit_radius_ < 0.6 * largest) // the points are denser than the ridges and show them
    return;
  if (!foot.valid || zoneOf(foot, foot.position, largest) != Zone::Main || reference_.inGap(foot.position))
    return;
  const Stock stock = field_.at(foot.position, foot.normal, move);
  const Eigen::Vector3d w = field_.across(foot, stock.met ? stock.move : move);
  const double step = stepAcross(foot, w);
  const double limit = std::min(farthest_ridge * step, fit_radius_);
  takeRidge(foot, field_.climbed(foot, stock, side * w, walk * step, limit), largest, extremes, nullptr);
}

void
RemovalSampler::along(std::size_t move, double f0, double f1, const SurfaceFoot& foot0, const SurfaceFoot& foot1,
                      RemovalExtremes& extremes) const
{
  constexpr int stations = 8;
  const double reach = 2.0 * fit_radius_; // the longest piece of a move
  if (!foot0.valid && !foot1.valid)
    return;
  const SurfaceFoot& first = foot0.valid ? foot0 : foot1;
  const SurfaceFoot& last = foot1.valid ? foot1 : foot0;
  if (reference_.inGap(first.position) || reference_.inGap(last.position) || reference_.inCreaseBand(first.position) ||
      reference_.inCreaseBand(last.position))
    return;
  for (int k = 0; k <= stations; ++k) {
    const double g = static_cast<double>(k) / stations, f = f0 + g * (f1 - f0);
    const SurfaceHeight at_first = g < 1.0 ? sweep_.lowest(move, f, first, reach) : SurfaceHeight();
    const SurfaceHeight at_last = g > 0.0 ? sweep_.lowest(move, f, last, reach) : SurfaceHeight();
    const SurfaceHeight guess{(1.0 - g) * at_first.height + g * at_last.height, (1.0 - g) * at_first.place + g * at_last.place};
    const bool outside = (g < 1.0 && first.overhang > 0.0) || (g > 0.0 && last.overhang > 0.0);
    if (-guess.height > (outside ? std::min(extremes.gouge.value, extremes.rim_gouge.value) : extremes.gouge.value))
      takeGouge(move, f, g < 0.5 ? first : last, guess.place, extremes);
  }
}

void
RemovalSampler::takeGouge(std::size_t move, double f, const SurfaceFoot& nearest, const Eigen::Vector3d& place,
                          RemovalExtremes& extremes) const
{
  std::vector<SurfaceFoot> feet;
  reference_.surface().project({place}, feet);
  // The extended quadric gives the place to test; the surface itself gives how deep the cutter is there, up to the rim.
  SurfaceFoot foot = feet.front().valid ? feet.front() : nearest;
  if (foot.overhang > 0.0)
    if (const auto rim = reference_.nearestOnRim(foot.position, foot.overhang + fit_radius_)) {
      const SurfaceFoot at_rim = reference_.surface().project(*rim);
      foot = at_rim.valid ? at_rim : foot;
    }
  const SurfaceHeight lowest = sweep_.lowest(move, f, foot, 0.0);
  const Eigen::Vector3d middle = (1.0 - f) * sweep_.centres()[move] + f * sweep_.centres()[move + 1];
  if ((middle - foot.position).dot(foot.normal) < 0.0 || reference_.inGap(foot.position))
    return; // another side of the part, or so deep that the reference points show it
  PlacedValue& gouge = reference_.inCreaseBand(foot.position) ? extremes.crease_gouge
                       : foot.overhang > 0.0                  ? extremes.rim_gouge
                                                              : extremes.gouge;
  raise(gouge, -lowest.height, foot.position, f < 0.5 ? move : move + 1);
}

} // namespace pcl_spiral
