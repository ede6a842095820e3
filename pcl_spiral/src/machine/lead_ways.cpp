// SPDX-License-Identifier: BSD-3-Clause
#include "lead_ways.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {} // namespace

/** From the far end of the lead to the path; \p inward is the direction of travel onto
 *  the path. */
std::vector<Eigen::Vector3d>
LeadWays::leadTips(const ToolPose& at, const Eigen::Vector3d& inward) const
{
  const Eigen::Vector3d along = inward - inward.dot(at.normal) * at.normal;
  const double radius = settings_.lead_length;
  if (settings_.lead == LeadKind::Normal || along.norm() < 1e-9)
    return {at.tip + radius * at.normal, at.tip};
  // Sagitta of a step: radius (1 - cos(step / 2)).
  const double share = std::min(1.0, settings_.block.tip / radius);
  const int steps = std::max(4, static_cast<int>(std::ceil(quarter_turn / (2.0 * std::acos(1.0 - share)))));
  std::vector<Eigen::Vector3d> tips;
  for (int i = 0; i <= std::min(steps, 1000); ++i) {
    const double angle = quarter_turn * (1.0 - static_cast<double>(i) / std::min(steps, 1000));
    tips.push_back(at.tip + radius * ((1.0 - std::cos(angle)) * at.normal - std::sin(angle) * along.normalized()));
  }
  return tips;
}

/** Along the tool axis to the clearance, on to the rapid height, then up to the top. */
std::vector<Eigen::Vector3d>
LeadWays::climb(const Eigen::Vector3d& from, const Eigen::Vector3d& axis) const
{
  const Eigen::Vector3d clear = from + settings_.clearance * axis;
  const Eigen::Vector3d high = clear + settings_.rapid_height * axis;
  return {clear, high, high + std::max(0.0, top_ - high.dot(up_)) * up_};
}

std::vector<LeadPlace>
LeadWays::entry(const ToolPose& at, const Eigen::Vector3d& travel) const
{
  const std::vector<Eigen::Vector3d> lead = leadTips(at, travel);
  const std::vector<Eigen::Vector3d> way = climb(lead.front(), at.axis);
  std::vector<LeadPlace> places{{way[2], BlockSection::Position, true},
                                {way[1], BlockSection::Approach, true},
                                {way[0], BlockSection::Approach, true},
                                {lead.front(), BlockSection::Approach, false}};
  for (std::size_t i = 1; i < lead.size(); ++i)
    places.push_back({lead[i], BlockSection::LeadIn, false});
  return places;
}

std::vector<LeadPlace>
LeadWays::exit(const ToolPose& at, const Eigen::Vector3d& travel) const
{
  const std::vector<Eigen::Vector3d> lead = leadTips(at, -travel);
  std::vector<LeadPlace> places;
  for (std::size_t i = lead.size() - 1; i-- > 0;)
    places.push_back({lead[i], BlockSection::LeadOut, false});
  const std::vector<Eigen::Vector3d> way = climb(lead.front(), at.axis);
  places.push_back({way[0], BlockSection::Retract, false});
  places.push_back({way[1], BlockSection::Retract, true});
  places.push_back({way[2], BlockSection::Retract, true});
  return places;
}

} // namespace pcl_spiral
