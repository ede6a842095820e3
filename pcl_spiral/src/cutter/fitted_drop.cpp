// SPDX-License-Identifier: BSD-3-Clause
#include "fitted_drop.h"

#include "core/model_touch.h"
#include "core/sampling_gap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr int most_starts = 4;
constexpr int most_rounds = 12;
constexpr double starts_apart = 2.0;     // in spacings
constexpr double longest_step = 1.5;     // in spacings: the fit spans about three
constexpr double still = 1e-4;           // in spacings: a contact that moves less has converged
constexpr double noisy = 0.01;           // in spacings: five standard deviations of the points
constexpr double steepest = 0.05;        // least cosine between normal and axis: 87 degrees
constexpr double largest_overhang = 0.5; // in spacings: farther beyond the outermost points a fit is not reliable

/** The normal on the side of the tool, and the curvatures seen from there. */
struct FacingFoot {
  FacingFoot(const SurfaceFoot& foot, const Eigen::Vector3d& axis)
  {
    const double side = foot.normal.dot(axis) < 0.0 ? -1.0 : 1.0;
    normal = side * foot.normal;
    share = normal.dot(axis);
    k1 = side * foot.curvature1;
    k2 = side * foot.curvature2;
  }
  Eigen::Vector3d normal;
  double share, k1, k2;
};

/** Heights of the foot's quadric along the axis, to the second degree. */
HeightModel
modelOf(const AxisFrame& frame, const SurfaceFoot& foot, const FacingFoot& facing)
{
  HeightModel model;
  model.at = frame.across(foot.position);
  model.height = frame.along(foot.position);
  model.slope = -Eigen::Vector2d(facing.normal.dot(frame.e1), facing.normal.dot(frame.e2)) / facing.share;
  const Eigen::Vector3d direction2 = foot.normal.cross(foot.direction1);
  const Eigen::Vector3d tangent[2] = {frame.e1 + model.slope.x() * frame.axis, frame.e2 + model.slope.y() * frame.axis};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      model.bend(i, j) = -(facing.k1 * tangent[i].dot(foot.direction1) * tangent[j].dot(foot.direction1) +
                           facing.k2 * tangent[i].dot(direction2) * tangent[j].dot(direction2)) /
                         facing.share;
  return model;
}

} // namespace

/** A place at which the search for a touch starts. */
struct FittedDrop::Start {
  Eigen::Vector3d query = Eigen::Vector3d::Zero();
  FittedContact contact;
  bool active = false;
};

double
FittedDrop::gapBound(const AxisFrame& frame, const SurfaceFoot& foot) const
{
  const FacingFoot facing(foot, frame.axis);
  SampledContact contact;
  contact.covering_radius =
      std::max(surface_.coveringRadius(foot.nearest), foot.nearest_distance) + foot.overhang; // no points beyond a rim
  contact.lean = std::acos(std::min(1.0, facing.share));
  contact.distance = frame.across(foot.position).norm();
  contact.curvature = std::max(facing.k1, facing.k2);
  return samplingGap(profile_, contact);
}

void
FittedDrop::findStarts(const AxisFrame& frame, const DropContact& drop, Start* starts) const
{
  struct Candidate {
    double height;
    std::uint32_t point;
  };
  const double spacing = surface_.surface().graph().spacing(), apart = starts_apart * spacing;
  const double margin = spacing * spacing / std::max(profile_.cornerRadius(), spacing);
  const CutterDrop* on = &drop_;
  double floor = drop.height - margin - surface_.noiseAllowance();
  std::optional<CutterDrop> feet;
  if (surface_.noiseAllowance() > noisy * spacing) { // the highest points are those with the most noise
    feet.emplace(surface_.feet(), profile_, ceiling_);
    on = &*feet;
    const DropContact top = feet->highest(frame);
    floor = (top.found ? top.height : floor) - margin;
  }
  std::vector<Candidate> candidates;
  on->visitAbove(frame, floor, [&](std::uint32_t point, double height) {
    if (height >= floor)
      candidates.push_back({height, point});
  });
  for (int k = 0; k < most_starts && !candidates.empty(); ++k) {
    const auto top = std::max_element(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.height != b.height ? a.height < b.height : a.point > b.point;
    });
    starts[k].query = on->blocks().position(top->point);
    starts[k].active = true;
    const auto near = [&](const Candidate& c) { return (on->blocks().position(c.point) - starts[k].query).norm() < apart; };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), near), candidates.end());
  }
}

void
FittedDrop::step(const AxisFrame& frame, const SurfaceFoot& foot, Start& start) const
{
  start.active = false;
  const SurfaceGraph& graph = surface_.surface().graph();
  const double spacing = graph.spacing(foot.nearest);
  const double most = largest_overhang * std::max(spacing, graph.spacing());
  start.contact.beyond = !surface_.covers(foot) || foot.overhang > most || surface_.beyondOutline(foot.position) > 1.01 * most;
  if (start.contact.beyond)
    return;
  const FacingFoot facing(foot, frame.axis);
  if (facing.share < steepest)
    return;
  const HeightModel model = modelOf(frame, foot, facing);
  const Eigen::Vector2d found = touchModel(profile_, model);
  const Eigen::Vector2d move = found - model.at;
  const double length = move.norm();
  const Eigen::Vector2d x = length > longest_step * spacing ? model.at + longest_step * spacing / length * move : found;
  start.query = frame.place(x, model.value(x));
  if (length > still * spacing) {
    start.active = true;
    return;
  }
  start.contact.found = true;
  start.contact.height = model.value(x) - profile_.height(std::min(x.norm(), profile_.radius()));
  start.contact.contact = start.query;
  start.contact.normal = facing.normal;
  start.contact.normal_share = facing.share;
  start.contact.gap_bound = gapBound(frame, foot);
}

void
FittedDrop::locate(const std::vector<AxisFrame>& frames, const std::vector<DropContact>& drops, std::vector<FittedContact>& contacts) const
{
  const auto count = static_cast<std::int64_t>(frames.size());
  std::vector<Start> starts(frames.size() * most_starts);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t i = 0; i < count; ++i)
    if (drops[i].found)
      findStarts(frames[i], drops[i], &starts[i * most_starts]);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<std::uint32_t> which;
    std::vector<Eigen::Vector3d> queries;
    for (std::size_t s = 0; s < starts.size(); ++s)
      if (starts[s].active) {
        which.push_back(static_cast<std::uint32_t>(s));
        queries.push_back(starts[s].query);
      }
    if (which.empty())
      break;
    std::vector<SurfaceFoot> feet;
    surface_.surface().project(queries, feet);
#pragma omp parallel for schedule(static)
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(which.size()); ++k)
      step(frames[which[k] / most_starts], feet[k], starts[which[k]]);
  }
  contacts.assign(frames.size(), FittedContact());
  for (std::size_t s = 0; s < starts.size(); ++s) {
    FittedContact& best = contacts[s / most_starts];
    if (starts[s].contact.found && (!best.found || starts[s].contact.height > best.height))
      best = starts[s].contact;
    best.beyond = !best.found && (best.beyond || starts[s].contact.beyond);
  }
}

} // namespace pcl_spiral
