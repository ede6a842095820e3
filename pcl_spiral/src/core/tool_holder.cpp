// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/tool_holder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl_spiral {

Diagnostic
faultOf(const std::vector<ToolSegment>& segments)
{
  constexpr double largest = 1e6; // mm
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ToolSegment& s = segments[i];
    const Diagnostic segment("segment ", i + 1, " of the holder", s.name.empty() ? "" : " (" + s.name + ")");
    if (!(s.length > 0.0) || !(s.length <= largest))
      return Diagnostic(segment, " is ", s.length, " {mm} long; set its length above 0");
    if (!(s.lower_radius > 0.0) || !(s.lower_radius <= largest))
      return Diagnostic(segment, " has the lower radius ", s.lower_radius, " {mm}; set it above 0");
    if (!(s.upper_radius > 0.0) || !(s.upper_radius <= largest))
      return Diagnostic(segment, " has the upper radius ", s.upper_radius, " {mm}; set it above 0");
  }
  return {};
}

HolderProfile::HolderProfile(const std::vector<ToolSegment>& segments, double base, double cutter_radius, double clearance)
{
  if (const Diagnostic fault = faultOf(segments); !fault.empty())
    throw std::invalid_argument("HolderProfile: " + fault.text());
  if (!(clearance >= 0.0) || !std::isfinite(clearance))
    throw std::invalid_argument("HolderProfile: the clearance must not be negative");
  double height = base, below = cutter_radius;
  bottom_ = base;
  for (const ToolSegment& s : segments) {
    const double slope = (s.upper_radius - s.lower_radius) / s.length, cosine = 1.0 / std::hypot(1.0, slope);
    const double sideways = clearance / cosine, down = s.lower_radius > below ? clearance : 0.0;
    parts_.push_back({height - down, height, height + s.length, s.lower_radius + sideways, slope, cosine, below});
    radius_ = std::max({radius_, s.lower_radius + sideways, s.upper_radius + sideways});
    bottom_ = std::min(bottom_, height - down);
    height += s.length;
    below = s.upper_radius;
  }
  top_ = height;
}

int
HolderProfile::inside(double l, double height, double& depth) const
{
  return mayBeInside(l, height, height, depth);
}

int
HolderProfile::mayBeInside(double l, double low, double high, double& depth) const
{
  int found = -1;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (high <= part.bottom || low > part.top)
      continue;
    const double highest = std::min(high, part.top), widest_at = part.slope > 0.0 ? highest : low;
    const double radius = part.radius + part.slope * std::max(0.0, widest_at - part.start);
    const double down = l > part.below ? highest - part.bottom : std::numeric_limits<double>::infinity();
    const double out = std::min((radius - l) * part.cosine, down);
    if (out > 0.0 && (found < 0 || out > depth)) {
      depth = out;
      found = static_cast<int>(i);
    }
  }
  return found;
}

} // namespace pcl_spiral
