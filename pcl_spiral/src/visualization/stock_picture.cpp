#include "canvas.h"
#include "verification_map.h"

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {

void
VerificationPictures::writeStock(const std::string& file) const
{
  const VerificationScene& scene = scene_;
  const pcl::PointCloud<ToolpathPoint>& path = *scene.part.path;
  const RemovalFigures& figures = scene.removal_figures;
  if (scene.stock.empty())
    throw std::logic_error("a picture of the stock needs the stock of each reference point");
  const StockScale scale(scene);
  const std::vector<float> heights = scale.heights(scene);
  Canvas canvas(*surface_);
  const ValueStyle style = scale.style();
  canvas.add(surfaceActor(surface_->mesh, surface_color));
  const double radius = discRadius(*surface_, heights.size());
  addPointMap(canvas, DepthMap(*surface_, canvas), *scene.part.cloud, heights,
              std::clamp(radius / canvas.projection().mm_per_pixel, 1.0, 6.0), style);
  canvas.addAxes();
  canvas.addColorBar("stock left, mm", "%.3g", scale.colors());
  std::vector<LegendEntry> legend = scale.legend(heights);
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
  const Title title = stockTitle(scene);
  canvas.addTitle(title.first, title.second);
  canvas.save(file);
}

} // namespace pcl_spiral
