#include "verification_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr Color gouge_color{0.84, 0.04, 0.07}, uncut_color{0.93, 0.16, 0.88}, above_color{1.00, 0.55, 0.00};
constexpr double disc_of_spacing = 0.9; ///< discs of this radius leave no gaps between neighbours

/** What counts as what. */
struct Classes {
  double gouge; ///< depth
  double limit, reach;

  explicit Classes(const VerificationScene& scene)
      : gouge(std::max(scene.part.settings.chord_error, 3.0 * scene.removal_figures.fit_noise)),
        limit(scene.removal_figures.limit), reach(scene.removal_figures.reach * (1.0 - 1e-5))
  {
  }
  bool
  isGouge(float v) const
  {
    return v < -gouge;
  }
  bool
  isUncut(float v) const
  {
    return v >= reach;
  }
  bool
  isAbove(float v) const
  {
    return v > limit && !isUncut(v);
  }
};

/** Per point the ridge next to it, the stock itself where there is none, or a gouge. */
std::vector<float>
shownHeights(const VerificationScene& scene, const Classes& classes)
{
  std::vector<float> heights = scene.stock;
  for (std::size_t i = 0; i < scene.ridges.size(); ++i)
    if (!std::isnan(scene.ridges[i]) && !std::isnan(heights[i]) && !classes.isGouge(heights[i]))
      heights[i] = std::max(heights[i], scene.ridges[i]);
  return heights;
}

ValueStyle
styleOf(const Classes& classes, vtkScalarsToColors* colors)
{
  // gouges before uncut places before heights: what is gone cannot be made good
  return {[classes](float v) {
            const auto high = static_cast<float>(classes.reach + classes.gouge);
            return classes.isGouge(v) ? 2.0f * high - v : static_cast<float>(classes.gouge) + v;
          },
          [classes, colors](float v) -> Color {
            if (classes.isGouge(v))
              return gouge_color;
            if (classes.isUncut(v))
              return uncut_color;
            if (classes.isAbove(v))
              return above_color;
            Color color;
            colors->GetColor(v, color.data());
            return color;
          },
          [classes](float v) { return classes.isGouge(v) || v > classes.limit; }};
}

std::vector<LegendEntry>
legendOf(const std::vector<float>& heights, const Classes& classes)
{
  std::size_t gouges = 0, uncut = 0, above = 0, all = 0;
  for (const float v : heights) {
    all += !std::isnan(v);
    gouges += classes.isGouge(v);
    uncut += classes.isUncut(v);
    above += classes.isAbove(v);
  }
  const auto share = [all](std::size_t count) {
    return count == 0 ? std::string("none")
                      : text("%.2g %%", 100.0 * static_cast<double>(count) /
                                            static_cast<double>(std::max<std::size_t>(all, 1)));
  };
  return {{text("gouge over %.3g mm: ", classes.gouge) + share(gouges), gouge_color},
          {text("uncut, over %.3g mm: ", classes.reach) + share(uncut), uncut_color},
          {text("above limit, %.3g mm: ", classes.limit) + share(above), above_color}};
}

} // namespace

void
VerificationPictures::writeStock(const std::string& file) const
{
  const VerificationScene& scene = scene_;
  const pcl::PointCloud<ToolpathPoint>& path = *scene.part.path;
  const RemovalFigures& figures = scene.removal_figures;
  if (scene.stock.empty())
    throw std::logic_error("a picture of the stock needs the stock of each reference point");
  const Classes classes(scene);
  const std::vector<float> heights = shownHeights(scene, classes);
  Canvas canvas(*surface_);
  const auto colors = colorScale(-classes.gouge, classes.limit);
  const ValueStyle style = styleOf(classes, colors);
  canvas.view()->AddActor(surfaceActor(surface_->mesh, surface_color));
  const double drawn = static_cast<double>(std::max<vtkIdType>(surface_->mesh->GetNumberOfPoints(), 1));
  const double radius = disc_of_spacing * surface_->spacing *
                        std::sqrt(drawn / std::max(static_cast<double>(heights.size()), drawn));
  addPointMap(canvas, DepthMap(*surface_, canvas), *scene.part.cloud, heights,
              std::clamp(radius / canvas.projection().mm_per_pixel, 1.0, 6.0), style);
  canvas.addAxes();
  canvas.addColorBar("stock left, mm", "%.3g", colors);
  std::vector<LegendEntry> legend = legendOf(heights, classes);
  const double across = insetWidth(*surface_, path);
  const auto show = [&](int slot, const PlacedValue& worst, const std::string& name) {
    const bool hidden = canvas.addCircle(worst.position);
    legend.push_back(
        {name + text(", %.3g mm", worst.value) + (hidden ? ", hidden" : ""), ink, Marker::Circle});
    addPointInset(
        canvas, slot, *surface_,
        {worst.position, pathPoint(path, worst.index).getNormalVector3fMap().cast<double>(), across, name},
        *scene.part.cloud, heights, radius, style, path);
  };
  if (figures.gouge.value > 0.0)
    show(0, figures.gouge, "deepest gouge");
  if (figures.stock.uncut > 0)
    show(1, figures.stock.first_uncut, "an uncut place");
  else if (figures.scallop.max.value > 0.0)
    show(1, figures.scallop.max, "highest ridge");
  canvas.addLegend(legend);
  canvas.addTitle(scene.part.title + ": stock left on the scan",
                  text("ball radius %g mm, scallop %g mm, chord error %g mm; ",
                       scene.part.settings.tool_radius, scene.part.settings.scallop_height,
                       scene.part.settings.chord_error) +
                      text("the surface of the scan is known to %.2g mm", 3.0 * figures.fit_noise));
  canvas.save(file);
}

} // namespace pcl_spiral
