// SPDX-License-Identifier: BSD-3-Clause
#include "actors.h"

#include "value_style.h"
#include "verify/least_gouge.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr Color gouge_color{0.84, 0.04, 0.07}, uncut_color{0.93, 0.16, 0.88}, above_color{1.00, 0.55, 0.00};

} // namespace

StockScale::StockScale(const VerificationScene& scene)
: gouge_(leastGouge(scene.part.settings.chord_error, scene.removal_figures.fit_noise)), limit_(scene.removal_figures.limit),
  reach_(scene.removal_figures.reach * (1.0 - 1e-5)), colors_(colorScale(-gouge_, limit_))
{}

bool
StockScale::isGouge(float v) const
{
  return v < -gouge_;
}

bool
StockScale::isUncut(float v) const
{
  return v >= reach_;
}

bool
StockScale::isAbove(float v) const
{
  return v > limit_ && !isUncut(v);
}

std::vector<float>
StockScale::heights(const VerificationScene& scene) const
{
  std::vector<float> heights = scene.stock;
  for (std::size_t i = 0; i < scene.ridges.size(); ++i)
    if (!std::isnan(scene.ridges[i]) && !std::isnan(heights[i]) && !isGouge(heights[i]))
      heights[i] = std::max(heights[i], scene.ridges[i]);
  return heights;
}

ValueStyle
StockScale::style() const
{
  // gouges before uncut places before heights: a gouge cannot be repaired
  return {[scale = *this](float v) {
            const auto high = static_cast<float>(scale.reach_ + scale.gouge_);
            return scale.isGouge(v) ? 2.0f * high - v : static_cast<float>(scale.gouge_) + v;
          },
          [scale = *this](float v) -> Color {
            if (scale.isGouge(v))
              return gouge_color;
            if (scale.isUncut(v))
              return uncut_color;
            if (scale.isAbove(v))
              return above_color;
            Color color;
            scale.colors_->GetColor(v, color.data());
            return color;
          },
          [scale = *this](float v) { return scale.isGouge(v) || v > scale.limit_; }};
}

std::vector<LegendEntry>
StockScale::legend(const std::vector<float>& heights) const
{
  std::size_t gouges = 0, uncut = 0, above = 0, all = 0;
  for (const float v : heights) {
    all += !std::isnan(v);
    gouges += isGouge(v);
    uncut += isUncut(v);
    above += isAbove(v);
  }
  const auto share = [all](std::size_t count) {
    return count == 0 ? std::string("none")
                      : formatted("%.2g %%", 100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(all, 1)));
  };
  return {{formatted("points gouged over %.3g mm: ", gouge_) + share(gouges), gouge_color},
          {formatted("points uncut, over %.3g mm: ", reach_) + share(uncut), uncut_color},
          {formatted("points above limit, %.3g mm: ", limit_) + share(above), above_color}};
}

LegendEntry
WorstStock::legend(bool hidden) const
{
  return {name + formatted(", %.3g mm", value.value) + (hidden ? ", hidden" : ""), ink, Marker::Circle};
}

std::vector<WorstStock>
worstStock(const RemovalReport& figures)
{
  std::vector<WorstStock> worst;
  if (figures.gouge.value > 0.0)
    worst.push_back({0, figures.gouge, "deepest gouge of a move"});
  if (figures.stock.uncut > 0)
    worst.push_back({1, figures.stock.first_uncut, "an uncut place"});
  else if (figures.scallop.max.value > 0.0)
    worst.push_back({1, figures.scallop.max, "highest ridge"});
  return worst;
}

Title
stockTitle(const VerificationScene& scene)
{
  const SpiralSettings& asked = scene.part.settings;
  return {scene.part.title + ": stock left on the " + std::string(scene.deviation_figures.by_mesh ? "mesh" : "scan"),
          formatted("ball radius %g mm, scallop %g mm, chord error %g mm; ", asked.tool_radius, asked.scallop_height, asked.chord_error) +
              formatted(scene.deviation_figures.by_mesh ? "the surface of the mesh is known to %.2g mm"
                                                        : "the surface of the scan is known to %.2g mm",
                        scene.removal_figures.fit_noise)};
}

} // namespace pcl_spiral
