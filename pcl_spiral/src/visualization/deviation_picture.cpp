#include "verification_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr Color above_color{0.85, 0.00, 0.75}, below_color{0.00, 0.40, 0.20},
    unmeasured_color{0.15, 0.15, 0.15};

constexpr double least_reach = 0.0002; ///< mm: below, colours would tell of nothing a scan or a machine knows

/** Half the range of the colours, mm: a single far point must not wash out all others. */
double
colorReach(const DeviationFigures& figures)
{
  const double wanted = std::max(least_reach, std::min(std::abs(figures.max.value), 2.0 * figures.p99));
  const double step = niceStep(0.1 * wanted);
  return step * (std::ceil(wanted / step - 1e-9) + 1e-6); // a value at its end, rounded up, belongs to it
}

ValueStyle
styleOf(double reach, vtkScalarsToColors* colors)
{
  return {[](float v) { return std::isnan(v) ? 0.0f : std::abs(v); },
          [reach, colors](float v) -> Color {
            if (std::isnan(v))
              return unmeasured_color;
            if (std::abs(v) > reach)
              return v > 0.0f ? above_color : below_color;
            Color color;
            colors->GetColor(v, color.data());
            return color;
          },
          [reach](float v) { return std::abs(v) > reach; }};
}

std::vector<LegendEntry>
legendOf(const VerificationScene& scene, double reach, bool hidden)
{
  const DeviationFigures& figures = scene.deviation_figures;
  std::vector<LegendEntry> legend{
      {text("largest, %+.5f mm", figures.max.value) + (hidden ? ", hidden by the part" : ""), ink,
       Marker::Circle}};
  std::size_t above = 0, below = 0, unmeasured = 0;
  for (const float v : scene.deviation) {
    above += v > reach;
    below += v < -reach;
    unmeasured += std::isnan(v);
  }
  const auto add = [&legend](std::size_t count, const std::string& what, const Color& color) {
    if (count > 0)
      legend.push_back({what + ": " + std::to_string(count) + (count == 1 ? " point" : " points"), color});
  };
  add(above, text("above %+.3g mm", reach), above_color);
  add(below, text("below %+.3g mm", -reach), below_color);
  add(unmeasured, "no surface there", unmeasured_color);
  return legend;
}

} // namespace

void
VerificationPictures::writeDeviation(const std::string& file) const
{
  const VerificationScene& scene = scene_;
  const pcl::PointCloud<ToolpathPoint>& path = *scene.part.path;
  const DeviationFigures& figures = scene.deviation_figures;
  if (scene.deviation.empty())
    throw std::logic_error("a picture of deviations needs the deviation of each path point");
  Canvas canvas(*surface_);
  const double reach = colorReach(figures);
  const auto colors = divergingScale(reach);
  const ValueStyle style = styleOf(reach, colors);
  canvas.view()->AddActor(surfaceActor(surface_->mesh, surface_color));
  addPathMap(canvas, DepthMap(*surface_, canvas), *surface_, path, scene.deviation, style);
  canvas.addAxes();
  const ToolpathPoint& worst = pathPoint(path, figures.max.index);
  const Eigen::Vector3d place = worst.getVector3fMap().cast<double>();
  const bool hidden = canvas.addCircle(place);
  canvas.addColorBar("deviation of the path, mm", "%.3g", colors);
  canvas.addLegend(legendOf(scene, reach, hidden));
  addPathInset(
      canvas, 1, *surface_,
      {place, worst.getNormalVector3fMap().cast<double>(), insetWidth(*surface_, path), "the largest"}, path,
      scene.deviation, style);
  canvas.addTitle(scene.part.title + ": deviation of the path from the scan",
                  text("99 %% within %.5f mm, rms %.5f mm; ", figures.p99, figures.rms) +
                      text("the surface of the scan is known to %.2g mm", 3.0 * figures.fit_noise));
  canvas.save(file);
}

} // namespace pcl_spiral
