// SPDX-License-Identifier: BSD-3-Clause
#include "planning/left_out.h"

#include "cutter/tool_body.h"
#include <pcl_spiral/cutter/impl/holder_collision.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double largest_step = 0.25; // mm that a place of the tool moves between two tests

/** The tool against points that are not of the part. */
class Obstacles {
public:
  Obstacles(const PassSettings& settings, const std::vector<Eigen::Vector3f>& points, double allowed)
  : points_(points), allowed_(allowed), cutter_(settings.cutter), length_(toolLength(cutter_, settings.holder)),
    body_(cutterAndShank(cutter_, settings.holder, length_)),
    holder_(settings.holder, cutter_.topHeight(), cutter_.radius(), settings.holder_clearance)
  {
    const double depth = std::min(0.5 * settings.tolerance, cutter_.radius()); // of the wedge between two places of a cylinder
    step_ = std::min(largest_step, 2.0 * std::sqrt(depth * (2.0 * cutter_.radius() - depth)));
  }

  /** The deepest point on the straight move between two locations; depth 0 if none is deeper than allowed. */
  HolderCollision deepest(const ToolLocation& from, const ToolLocation& to) const
  {
    HolderCollision worst;
    if (points_.size() == 0)
      return worst;
    const Eigen::Vector3d way = to.tip - from.tip, at_top = way + length_ * (to.axis - from.axis);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::max(way.norm(), at_top.norm()) / step_)));
    for (int k = 1; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const AxisFrame frame(from.tip + share * way, (from.axis + share * (to.axis - from.axis)).normalized());
      for (const HolderProfile* part : {&body_, &holder_})
        if (const HolderCollision met = findCollision(points_, *part, frame, 0.0, allowed_); met.depth > worst.depth)
          worst = met;
    }
    return worst;
  }

private:
  PointBlocks points_;
  double allowed_;
  CutterProfile cutter_;
  double length_, step_;
  HolderProfile body_, holder_;
};

/** Whether the cutter enters one of the keep-outs between two locations. */
bool
enters(const PassSettings& settings, const std::vector<Prism>& keep_outs, const ToolLocation& from, const ToolLocation& to)
{
  const CutterProfile cutter(settings.cutter);
  const auto at = [&](const ToolLocation& l, double height) -> Eigen::Vector3d { return l.tip + height * l.axis; };
  const double low = cutter.cornerRadius(), high = low + settings.cutter.flank_length;
  return std::any_of(keep_outs.begin(), keep_outs.end(), [&](const Prism& prism) {
    return prism.distance(at(from, low), at(to, low)) < cutter.radius() || prism.distance(at(from, high), at(to, high)) < cutter.radius() ||
           prism.distance(at(to, low), at(to, high)) < cutter.radius();
  });
}

/** What is met between two locations. */
struct Met {
  bool enters = false;
  HolderCollision standing, beside;

  bool any() const { return enters || standing.found() || beside.found(); }
};

void
count(const Met& met, LeftOutLocations& left)
{
  if (met.enters) {
    ++left.entering;
    return;
  }
  const bool standing = met.standing.found();
  const HolderCollision& touched = standing ? met.standing : met.beside;
  std::size_t& number = standing ? left.touching : left.beside;
  double& deepest = standing ? left.deepest : left.deepest_beside;
  if (number++ == 0)
    (standing ? left.first : left.first_beside) = touched.place;
  deepest = std::max(deepest, touched.depth);
}

} // namespace

void
leaveOut(const PassSettings& settings, std::vector<ToolLocations>& located, PassPlan& plan)
{
  const ChosenPart& chosen = plan.chosen;
  if (chosen.keep_outs.empty() && chosen.beside.empty())
    return;
  const double allowed = settings.tolerance + plan.locations.noise_allowance;
  const Obstacles standing(settings, chosen.kept_out, allowed), beside(settings, chosen.beside, allowed);
  const auto meet = [&](const ToolLocation& from, const ToolLocation& to) {
    return Met{enters(settings, chosen.keep_outs, from, to), standing.deepest(from, to), beside.deepest(from, to)};
  };
  for (ToolLocations& pass : located) {
    std::vector<Met> at(pass.size()), on_way(pass.size());
#pragma omp parallel for schedule(dynamic, 64)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(pass.size()); ++i) {
      if (pass[i].state == LocationState::NoCloud)
        continue;
      at[i] = meet(pass[i], pass[i]);
      if (i > 0 && pass[i - 1].state != LocationState::NoCloud)
        on_way[i] = meet(pass[i - 1], pass[i]);
    }
    bool goes_on = false; // from the location before
    for (std::size_t i = 0; i < pass.size(); ++i) {
      const bool known = pass[i].state != LocationState::NoCloud;
      const Met& met = goes_on && !at[i].any() ? on_way[i] : at[i];
      goes_on = known && !met.any();
      if (known && met.any()) {
        count(met, plan.left_out);
        plan.left_out.contacts.push_back(pass[i].contact);
        pass[i].state = LocationState::NoCloud;
      }
    }
  }
}

} // namespace pcl_spiral
