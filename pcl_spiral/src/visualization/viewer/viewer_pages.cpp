// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_pages.h"

#include "cutter_actor.h"
#include "visualization/boundary_layer.h"
#include "visualization/histogram_chart.h"
#include "visualization/value_actors.h"
#include "visualization/verification_map.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double least_map_pitch = 2.0; ///< pixels between turns of the deviation map, which fill the surface
constexpr float thinnest_line = 2.0f, thickest_line = 4.0f, thin_line = 1.0f, smallest_point = 2.0f,
                largest_point = 16.0f;      ///< pixels
constexpr std::size_t most_points = 200000; ///< of the scan, drawn at the same time
constexpr Color chosen_color{0.10, 0.30, 0.90}, thin_color{0.05, 0.05, 0.08};

} // namespace

ViewerPages::ViewerPages(const VerificationScene& scene, ViewerWindow& window)
: scene_(scene), window_(window), near_width_(insetWidth(window.surface(), *scene.part.path)),
  disc_radius_(discRadius(window.surface(), scene.stock.size()))
{
  if (!scene.deviation.empty())
    deviation_outstanding_ = outstandingPoints(*scene.part.path, scene.deviation, DeviationScale(scene.deviation_figures).style());
  if (scene.stock.empty())
    return;
  const StockScale scale(scene);
  heights_ = scale.heights(scene);
  stock_outstanding_ = outstandingPoints(*scene.part.cloud, heights_, scale.style());
}

ShownTurns
ViewerPages::turns(const ViewerChoice& choice) const
{
  const bool map = choice.page == ViewerPage::Deviation;
  ShownTurns turns = chooseTurns(*scene_.part.path, window_.projection(), map ? least_map_pitch : least_turn_pitch);
  if (choice.every_turn)
    turns.every = 1;
  return turns;
}

int
ViewerPages::fill(const ViewerChoice& choice)
{
  window_.clear();
  switch (choice.page) {
  case ViewerPage::Boundaries:
    return boundaries();
  case ViewerPage::Path:
    return path(choice);
  case ViewerPage::Deviation:
    return scene_.deviation.empty() ? absent("the deviation of the path") : deviation(choice);
  case ViewerPage::Stock: {
    if (scene_.stock.empty())
      return absent("the stock left on the part");
    const int below = stock();
    addChosen(choice);
    return below;
  }
  case ViewerPage::Histogram:
    return hasHistogram(scene_) ? histogram() : absent("the histogram of scallops");
  case ViewerPage::Playback:
    break; // drawn by PlaybackPage
  }
  return window_.page().height;
}

int
ViewerPages::boundaries()
{
  const auto colors = heightColors(window_.surface());
  const std::vector<LegendEntry> legend = addBoundaries(window_, scene_.part.report, colors);
  window_.addMeasures();
  return addWords({boundariesTitle(scene_.part), partInWords(scene_.part)}, "height, mm", colors, legend);
}

int
ViewerPages::path(const ViewerChoice& choice)
{
  const pcl::PointCloud<ToolpathPoint>& path = *scene_.part.path;
  const SpiralSettings& asked = scene_.part.settings;
  const ShownTurns shown = turns(choice);
  const auto colors = colorScale(0.0, static_cast<double>(shown.turns));
  std::vector<LegendEntry> legend{addSpiral(window_, path, shown, colors)};
  addOverGaps(window_, path, shown, legend);
  for (const LegendEntry& end : markEnds(window_, path))
    legend.push_back(end);
  window_.addMeasures();
  addChosen(choice);
  return addWords(
      {scene_.part.title + ": " + std::to_string(shown.turns) + " turns, " + formatted("%.2f m", path.back().arc_length / 1000.0),
       std::to_string(path.size()) + " points" +
           (asked.tool_radius > 0.0 ? formatted(", ball radius %g mm, scallop %g mm", asked.tool_radius, asked.scallop_height) : "")},
      "turn", colors, legend);
}

int
ViewerPages::deviation(const ViewerChoice& choice)
{
  const pcl::PointCloud<ToolpathPoint>& path = *scene_.part.path;
  const DeviationScale scale(scene_.deviation_figures);
  const ShownTurns shown = turns(choice);
  const double pixel = window_.projection().mm_per_pixel;
  window_.add(surfaceActor(window_.surface().mesh, surface_color));
  const auto lines =
      valueLines(pathLines(path, least_path_move * pixel,
                           [&](const ToolpathPoint& point) { return shown.shows(point.turn) && window_.isNear(placeOf(point)); }),
                 scene_.deviation, scale.style());
  const double pitch = shown.every * near_width_ / inset_pitches / pixel;
  lines->GetProperty()->SetLineWidth(std::clamp(static_cast<float>(pitch), thinnest_line, thickest_line));
  window_.addOver(lines);
  int layers = 1;
  for (const auto& actor : deviation_outstanding_)
    window_.addOver(actor, ++layers);
  const ToolpathPoint& worst = pathPoint(path, scene_.deviation_figures.max.index);
  std::vector<LegendEntry> legend = scale.legend(scene_, window_.addCircle(placeOf(worst)));
  legend.push_back({shown.caption(), scale.style().color(0.0f)});
  window_.addMeasures();
  addChosen(choice);
  return addWords(deviationTitle(scene_), "deviation of the path, mm", scale.colors(), legend);
}

/** Points in and near the view; if there are too many, a fixed share of them as larger discs. */
void
ViewerPages::addStockPoints(const ValueStyle& style)
{
  const pcl::PointCloud<pcl::PointXYZ>& cloud = *scene_.part.cloud;
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!std::isnan(heights_[i]) && window_.isNear(cloud[i].getVector3fMap().cast<double>()))
      near.push_back(static_cast<std::uint32_t>(i));
  const double share = std::min(1.0, static_cast<double>(most_points) / static_cast<double>(near.size() + 1));
  double at = 0.0; // a low-discrepancy sequence: every part of the file keeps the same share of its points
  near.erase(
      std::remove_if(near.begin(), near.end(), [&](std::uint32_t) { return (at = std::fmod(at + 0.6180339887498949, 1.0)) > share; }),
      near.end());
  const auto points = valuePoints(cloud, near, heights_, style);
  const double size = 2.0 * disc_radius_ / std::sqrt(share);
  points->GetProperty()->SetPointSize(
      std::clamp(static_cast<float>(size / window_.projection().mm_per_pixel), smallest_point, largest_point));
  window_.addOver(points);
}

int
ViewerPages::stock()
{
  const pcl::PointCloud<ToolpathPoint>& path = *scene_.part.path;
  const StockScale scale(scene_);
  const double pixel = window_.projection().mm_per_pixel;
  window_.add(surfaceActor(window_.surface().mesh, surface_color));
  addStockPoints(scale.style());
  int layers = 1;
  if (const ShownTurns shown = turns(ViewerChoice()); shown.every == 1) {
    const auto lines =
        valueLines(pathLines(path, least_path_move * pixel, [&](const ToolpathPoint& point) { return window_.isNear(placeOf(point)); }),
                   std::vector<float>(path.size(), 0.0f), {{}, [](float) { return thin_color; }, {}});
    lines->GetProperty()->SetLineWidth(thin_line);
    window_.addOver(lines, ++layers);
  }
  for (const auto& actor : stock_outstanding_)
    window_.addOver(actor, ++layers);
  std::vector<LegendEntry> legend = scale.legend(heights_);
  for (const WorstStock& worst : worstStock(scene_.removal_figures))
    legend.push_back(worst.legend(window_.addCircle(worst.value.position)));
  window_.addMeasures();
  return addWords(stockTitle(scene_), "stock left, mm", scale.colors(), legend);
}

int
ViewerPages::histogram()
{
  const int below = addHistogram(window_.words(), window_.page(), scene_);
  const Title title = histogramTitle(scene_);
  addTitle(window_.words(), window_.page(), title.first, title.second);
  return below;
}

int
ViewerPages::absent(const std::string& what)
{
  addTitle(window_.words(), window_.page(), scene_.part.title, "");
  const double room = window_.page().wordsLeft() - 20.0;
  const Eigen::Vector2d middle(0.5 * window_.page().wordsLeft(), 0.5 * window_.page().height);
  addCentredText(window_.words(), "There are no data for " + what + ".", middle, 22, room);
  addCentredText(window_.words(), remedy_, middle - Eigen::Vector2d(0.0, 40.0), 20, room);
  return window_.page().column_top;
}

void
ViewerPages::addChosen(const ViewerChoice& choice)
{
  if (!choice.point)
    return;
  const ToolpathPoint& point = pathPoint(*scene_.part.path, *choice.point);
  window_.addCircle(placeOf(point), chosen_color);
  if (choice.cutter && scene_.part.settings.tool_radius > 0.0)
    window_.add(cutterActor(point, scene_.part.settings.tool_radius));
}

int
ViewerPages::addWords(const Title& title, const std::string& bar, vtkScalarsToColors* colors, const std::vector<LegendEntry>& legend)
{
  vtkRenderer* const words = window_.words();
  addTitle(words, window_.page(), title.first, title.second);
  addColorBar(words, window_.page(), bar, colors);
  return addLegend(words, window_.page(), legend);
}

} // namespace pcl_spiral
