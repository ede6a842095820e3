// SPDX-License-Identifier: BSD-3-Clause
#include "harmonic_field.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/polyline.h>

#include "harmonic_domain.h"
#include "level_fit.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double farthest_in_spacings = 4.0; // of a rim point from the cloud
constexpr double step_in_spacings = 2.0;     // of a line's points
constexpr double smoothed_in_spacings = 5.0; // shorter waves come from the triangles
constexpr double ragged_in_spacings = 2.5;   // from the outermost points inwards

/** Where \p value lies in the growing \p levels, whose last is a whole turn above the first. */
std::size_t
interval(const std::vector<double>& levels, double& value)
{
  value -= full_turn * std::floor((value - levels.front()) / full_turn);
  const auto after = std::upper_bound(levels.begin(), levels.end(), value);
  const auto at = static_cast<std::size_t>(after - levels.begin());
  return std::min(at, levels.size() - 1) - 1;
}

/** Cut off up to \p amount of the line's length from its end. */
void
shorten(Polyline& line, double amount)
{
  while (line.size() > 1) {
    const double last = (line.back() - line[line.size() - 2]).norm();
    if (last > amount) {
      line.back() += amount / last * (line[line.size() - 2] - line.back());
      return;
    }
    amount -= last;
    line.pop_back();
  }
}

} // namespace

double
HarmonicField::angleAt(const Eigen::Vector3d& point, std::uint32_t nearest) const
{
  return fitLevel(*graph_, nearest, point, [this](std::uint32_t h) { return growth(h); }) + angle_[nearest];
}

Eigen::Vector3d
HarmonicField::onEdge(const LevelEdge& at) const
{
  const Triangulation& mesh = graph_->triangulation();
  const double rise = growth(at.half_edge);
  const double share = rise != 0.0 ? std::clamp(at.above / rise, 0.0, 1.0) : 0.5;
  return (1.0 - share) * graph_->position(mesh.origin(at.half_edge)) + share * graph_->position(mesh.target(at.half_edge));
}

bool
HarmonicField::passTriangle(LevelEdge& at) const
{
  const Triangulation& mesh = graph_->triangulation();
  const HarmonicDomain& domain = *domain_;
  const std::uint32_t to_third = Triangulation::next(at.half_edge), from_third = Triangulation::previous(at.half_edge);
  bool third_is_above = -growth(from_third) >= at.above;
  // Both ends of the edge of a gap lie on the same side of every level.
  if (domain.kind[third_is_above ? from_third : to_third] == HarmonicDomain::Edge::Gap)
    third_is_above = !third_is_above;
  const std::uint32_t out = third_is_above ? from_third : to_third;
  if (!third_is_above)
    at.above += growth(from_third);
  at.half_edge = out;
  if (mesh.opposite(out) != Triangulation::none) {
    at.half_edge = mesh.opposite(out);
    return true;
  }
  if (domain.kind[out] != HarmonicDomain::Edge::Pocket)
    return false;
  // Round the pocket from the end of the edge that lies below to the edge on which the level is reached again.
  for (std::uint32_t h = domain.after.at(out); h != out; h = domain.after.at(h)) {
    const double rise = growth(h);
    if (rise > at.above) {
      at.half_edge = h;
      return true;
    }
    at.above -= rise;
  }
  return false;
}

Polyline
HarmonicField::levelLine(double angle) const
{
  const Triangulation& mesh = graph_->triangulation();
  const std::size_t first = interval(rim_angle_, angle);
  LevelEdge at{domain_->rim[first], angle - rim_angle_[first]};
  Polyline line{onEdge(at)};
  for (std::size_t steps = 0; steps <= mesh.triangleCount(); ++steps) {
    if (domain_->in_disc[mesh.origin(at.half_edge)] && domain_->in_disc[mesh.target(at.half_edge)])
      break;
    const bool inside = passTriangle(at);
    if (!inside) // the inner loop: its edge runs the other way
      at.above += growth(at.half_edge);
    line.push_back(onEdge(at));
    if (!inside)
      break;
  }
  return line;
}

void
HarmonicField::levelInnerCurve(const Polyline& inner_curve)
{
  const double step = 0.5 * graph_->spacing();
  const auto count = static_cast<std::size_t>(std::max(16.0, std::ceil(length(inner_curve, true) / step)));
  inner_curve_ = resampled(inner_curve, count, true);
  std::vector<double> level;
  for (const Eigen::Vector3d& p : inner_curve_) {
    const double angle = angleAt(p, graph_->blocks().nearest(p));
    level.push_back(level.empty() ? angle : angle + full_turn * std::round((level.back() - angle) / full_turn));
  }
  const double back = level[0] + full_turn * std::round((level.back() - level[0]) / full_turn);
  if (back < level[0]) { // the curve runs clockwise
    std::reverse(inner_curve_.begin(), inner_curve_.end());
    std::reverse(level.begin(), level.end());
  }
  inner_angle_ = growing(level, full_turn);
}

Eigen::Vector3d
HarmonicField::onInnerCurve(double angle) const
{
  const std::size_t i = interval(inner_angle_, angle);
  const double rise = inner_angle_[i + 1] - inner_angle_[i];
  const double share = rise > 0.0 ? (angle - inner_angle_[i]) / rise : 0.5;
  return (1.0 - share) * inner_curve_[i] + share * inner_curve_[(i + 1) % inner_curve_.size()];
}

Polyline
HarmonicField::smoothLine(const Eigen::Vector3d& on_rim) const
{
  if (!on_rim.allFinite())
    return {};
  const std::uint32_t nearest = graph_->blocks().nearest(on_rim);
  const double spacing = graph_->spacing();
  if ((graph_->position(nearest) - on_rim).norm() > farthest_in_spacings * std::max(spacing, graph_->spacing(nearest)))
    return {};
  const double angle = angleAt(on_rim, nearest);
  Polyline line = levelLine(angle);
  const double ragged = std::min(ragged_in_spacings * spacing, 0.3 * length(line));
  std::reverse(line.begin(), line.end());
  shorten(line, ragged);
  line.push_back(on_rim);
  std::reverse(line.begin(), line.end());
  if (!inner_curve_.empty())
    shorten(line, ragged);
  line.push_back(inner_curve_.empty() ? domain_->centre : onInnerCurve(angle));
  std::reverse(line.begin(), line.end());

  TaubinOptions smoothing;
  smoothing.wavelength = smoothed_in_spacings * spacing;
  smoothing.mu = -smoothing.lambda;
  smoothing.threads = 1;
  const double whole = length(line);
  line = resampled(line, static_cast<std::size_t>(std::max(4.0, std::ceil(4.0 * whole / spacing))));
  line = taubinSmoothed(line, smoothing);
  return resampled(line, 1 + static_cast<std::size_t>(std::max(2.0, std::ceil(whole / (step_in_spacings * spacing)))));
}

std::vector<Polyline>
HarmonicField::trace(const Polyline& on_rim) const
{
  std::vector<Polyline> lines(on_rim.size());
  if (!surface_)
    return lines;
  const auto count = static_cast<std::int64_t>(lines.size());
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t l = 0; l < count; ++l)
    lines[l] = smoothLine(on_rim[l]);
  // Put all points except the ends onto the surface, in one call.
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (const Polyline& line : lines)
    if (!line.empty())
      queries.insert(queries.end(), line.begin() + 1, line.end() - 1);
  surface_->project(queries, feet);
  std::size_t at = 0;
  for (Polyline& line : lines)
    for (std::size_t i = 1; i + 1 < line.size(); ++i, ++at)
      if (feet[at].valid)
        line[i] = feet[at].position;
  return lines;
}

Polyline
HarmonicField::trace(const Eigen::Vector3d& on_rim) const
{
  return trace(Polyline{on_rim})[0];
}

} // namespace pcl_spiral
