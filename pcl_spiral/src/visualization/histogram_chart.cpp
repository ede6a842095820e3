// SPDX-License-Identifier: BSD-3-Clause
#include "histogram_chart.h"

#include "box_axes.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Boxes = std::vector<std::array<Eigen::Vector2d, 2>>;

constexpr double left = 130.0, bottom = 110.0, right_margin = 50.0,
                 chart_top_margin = 200.0;    ///< of the chart, pixels
constexpr double number_room = 1010.0 / 12.0; ///< pixels along the axis for one number
constexpr double tick = axis_tick_length;
constexpr int bins_to_limit = 40;
constexpr int words_below = 230; ///< top of the text column, pixels
constexpr double least_decades = 1.0,
                 below_one = 0.3; ///< of the logarithmic scale: a bar for a single ridge also has a height
constexpr Color within_color{0.128, 0.567, 0.551}, above_limit_color{1.00, 0.55, 0.00}, asked_color{0.10, 0.22, 0.66},
    limit_color{0.84, 0.04, 0.07};

/** Number of values in each bin; values outside count in the first and the last. */
struct Bins {
  double width;
  int first, last; ///< of bins from k width to (k + 1) width
  std::vector<std::size_t> counts;
  std::size_t all = 0, beyond = 0, below = 0, most = 1;

  Bins(const std::vector<float>& values, double limit) : width(limit / bins_to_limit)
  {
    double low = 0.0, high = 0.0;
    for (const float v : values)
      if (!std::isnan(v)) {
        low = std::min<double>(low, v);
        high = std::max<double>(high, v);
      }
    first = static_cast<int>(std::floor(std::max(low / width, -0.5 * bins_to_limit)));
    last = static_cast<int>(std::floor(std::clamp(high / width, 1.3 * bins_to_limit, 3.0 * bins_to_limit)));
    counts.resize(last - first + 1);
    for (const float v : values)
      if (!std::isnan(v))
        add(v / width);
    most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  }
  void add(double at)
  {
    ++all;
    beyond += at >= last + 1;
    below += at < first;
    ++counts[static_cast<std::size_t>(std::floor(std::clamp<double>(at, first, last)) - first)];
  }
};

/** Places on the chart. */
struct Scale {
  double right, top; ///< of the chart, pixels
  double low, high, decades;

  Scale(const PageSize& page, const Bins& bins)
  : right(page.wordsLeft() - right_margin), top(page.height - chart_top_margin), low(bins.first * bins.width),
    high((bins.last + 1) * bins.width), decades(std::max(least_decades, std::log10(static_cast<double>(bins.most)) + 0.1))
  {}
  double x(double height) const { return left + (right - left) * (height - low) / (high - low); }
  double y(double count) const { return bottom + (top - bottom) * (std::log10(count) + below_one) / (decades + below_one); }
};

void
addBars(vtkRenderer* view, const Bins& bins, const Scale& scale)
{
  Boxes within, above;
  for (std::size_t i = 0; i < bins.counts.size(); ++i) {
    const int k = bins.first + static_cast<int>(i);
    if (bins.counts[i] > 0)
      (k < bins_to_limit ? within : above)
          .push_back({Eigen::Vector2d(scale.x(k * bins.width) + 1.0, bottom),
                      Eigen::Vector2d(scale.x((k + 1) * bins.width) - 1.0, scale.y(static_cast<double>(bins.counts[i])))});
  }
  addBoxes(view, within, within_color);
  addBoxes(view, above, above_limit_color);
}

void
addAxes(vtkRenderer* view, const Scale& scale)
{
  Boxes strokes{{Eigen::Vector2d(left, bottom), Eigen::Vector2d(scale.right, bottom)},
                {Eigen::Vector2d(left, bottom), Eigen::Vector2d(left, scale.top)}};
  const double step = niceStep((scale.high - scale.low) * number_room / (scale.right - left));
  for (double k = std::ceil(scale.low / step - 1e-9); k * step <= scale.high * (1.0 + 1e-9); k += 1.0) {
    const double x = scale.x(k * step);
    strokes.push_back({Eigen::Vector2d(x, bottom), Eigen::Vector2d(x, bottom - tick)});
    addCentredText(view, formatted("%.6g", k == 0.0 ? 0.0 : k * step), {x, bottom - 26.0}, number_size);
  }
  for (int decade = 0; decade <= scale.decades; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      const double count = digit * std::pow(10.0, decade), y = scale.y(count);
      if (y > scale.top)
        break;
      strokes.push_back({Eigen::Vector2d(left, y), Eigen::Vector2d(left - (digit == 1 ? tick : 0.5 * tick), y)});
      if (digit == 1)
        addCentredText(view, formatted("%.0f", count), {left - 50.0, y}, number_size);
    }
  addStrokes(view, strokes, ink, 1.5f);
  addCentredText(view, "height of the ridge between turns, mm", {0.5 * (left + scale.right), 45.0}, name_size);
  addText(view, "ridges, logarithmic scale", 30, static_cast<int>(scale.top) + 42, name_size);
}

/** A vertical line at \p height with text at its top: on the left if asked for and if there is room. */
void
addLine(vtkRenderer* view, const Scale& scale, double height, const std::string& words, const Color& color, bool on_left)
{
  const double x = scale.x(height), room = 0.285 * name_size * static_cast<double>(words.size()) + 10.0;
  on_left = on_left && x > 2.0 * room;
  addStrokes(view, {{Eigen::Vector2d(x, bottom), Eigen::Vector2d(x, scale.top + 25.0)}}, color, 2.5f);
  addCentredText(view, words, {on_left ? x - room : x + room, scale.top + 17.0}, name_size);
}

/** Returns the position of the next line. */
int
addWords(vtkRenderer* view, const PageSize& page, const Bins& bins, const StockReport& figures, double limit)
{
  addLegend(view, page,
            {{formatted("up to the limit, %.3g mm", limit), within_color},
             {formatted("above it: %.2g %%", 100.0 * figures.share_above), above_limit_color}});
  int y = page.column_top - words_below;
  const auto add = [&](const std::string& words) {
    addText(view, words, page.wordsLeft(), y, name_size);
    y -= 30;
  };
  add(std::to_string(bins.all) + " ridges");
  add(formatted("half of them below %.3g mm", figures.p50));
  add(formatted("90 %% below %.3g mm", figures.p90));
  add(formatted("99 %% below %.3g mm", figures.p99));
  add(formatted("99.9 %% below %.3g mm", figures.p999));
  add(formatted("the highest %.3g mm", figures.max.value));
  if (bins.beyond > 0)
    add("last bar: " + std::to_string(bins.beyond) + formatted(" above %.3g mm", (bins.last + 1) * bins.width));
  if (bins.below > 0)
    add("first bar: " + std::to_string(bins.below) + formatted(" below %.3g mm", bins.first * bins.width));
  return y;
}

} // namespace

bool
hasHistogram(const VerificationScene& scene)
{
  return scene.removal_figures.limit > 0.0 && std::any_of(scene.ridges.begin(), scene.ridges.end(), [](float v) { return !std::isnan(v); });
}

int
addHistogram(vtkRenderer* view, const PageSize& page, const VerificationScene& scene)
{
  const SpiralSettings& asked = scene.part.settings;
  const RemovalReport& figures = scene.removal_figures;
  const Bins bins(scene.ridges, figures.limit);
  const Scale scale(page, bins);
  addBars(view, bins, scale);
  addAxes(view, scale);
  addLine(view, scale, asked.scallop_height, formatted("asked for, h: %.3g", asked.scallop_height), asked_color, true);
  addLine(view, scale, figures.limit, formatted("limit, 1.02 h + e: %.3g", figures.limit), limit_color, false);
  return addWords(view, page, bins, figures.scallop, figures.limit);
}

Title
histogramTitle(const VerificationScene& scene)
{
  const SpiralSettings& asked = scene.part.settings;
  return {scene.part.title + ": heights of the ridges between turns",
          formatted("ball radius %g mm, scallop %g mm, chord error %g mm", asked.tool_radius, asked.scallop_height, asked.chord_error)};
}

} // namespace pcl_spiral
