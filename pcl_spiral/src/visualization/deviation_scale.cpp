// SPDX-License-Identifier: BSD-3-Clause
#include "actors.h"
#include "value_style.h"

#include "box_axes.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr Color above_color{0.85, 0.00, 0.75}, below_color{0.00, 0.40, 0.20}, unmeasured_color{0.15, 0.15, 0.15};

constexpr double least_reach = 0.0002; ///< mm: scans and machines do not resolve less

/** A single large value must not make all other colours pale. */
double
colorReach(const DeviationReport& figures)
{
  const double wanted = std::max(least_reach, std::min(std::abs(figures.max.value), 2.0 * figures.p99));
  const double step = niceStep(0.1 * wanted);
  return step * (std::ceil(wanted / step - 1e-9) + 1e-6); // a rounded value at the end of the scale belongs to it
}

} // namespace

DeviationScale::DeviationScale(const DeviationReport& figures) : reach_(colorReach(figures)), colors_(divergingScale(reach_)) {}

ValueStyle
DeviationScale::style() const
{
  return {[](float v) { return std::isnan(v) ? 0.0f : std::abs(v); },
          [reach = reach_, colors = colors_](float v) -> Color {
            if (std::isnan(v))
              return unmeasured_color;
            if (std::abs(v) > reach)
              return v > 0.0f ? above_color : below_color;
            Color color;
            colors->GetColor(v, color.data());
            return color;
          },
          [reach = reach_](float v) { return std::abs(v) > reach; }};
}

std::vector<LegendEntry>
DeviationScale::legend(const VerificationScene& scene, bool hidden) const
{
  const DeviationReport& figures = scene.deviation_figures;
  std::vector<LegendEntry> legend{
      {formatted("largest of the judged points, %+.5f mm", figures.max.value) + (hidden ? ", hidden by the part" : ""), ink,
       Marker::Circle}};
  std::size_t above = 0, below = 0, unmeasured = 0;
  for (const float v : scene.deviation) {
    above += v > reach_;
    below += v < -reach_;
    unmeasured += std::isnan(v);
  }
  const auto add = [&legend](std::size_t count, const std::string& what, const Color& color) {
    if (count > 0)
      legend.push_back({what + ": " + std::to_string(count) + (count == 1 ? " point" : " points"), color});
  };
  add(above, formatted("above %+.3g mm", reach_), above_color);
  add(below, formatted("below %+.3g mm", -reach_), below_color);
  add(unmeasured, "not judged", unmeasured_color);
  const auto addBeyond = [&](std::size_t count, const char* where, double value) {
    if (count > 0 && std::abs(value) > std::abs(figures.max.value))
      legend.push_back({where + formatted(": up to %+.3g mm, not judged", value), ink});
  };
  addBeyond(figures.beyond_rim, "beyond the rim", figures.rim_max.value);
  addBeyond(figures.in_gaps, "over gaps", figures.gap_max.value);
  return legend;
}

Title
deviationTitle(const VerificationScene& scene)
{
  const DeviationReport& figures = scene.deviation_figures;
  return {scene.part.title + ": deviation of the path from the " + std::string(figures.by_mesh ? "mesh" : "scan"),
          formatted("99 %% within %.5f mm, rms %.5f mm; ", figures.p99, figures.rms) +
              formatted(figures.by_mesh ? "the surface of the mesh is known to %.2g mm" : "the surface of the scan is known to %.2g mm",
                        figures.fit_noise)};
}

} // namespace pcl_spiral
