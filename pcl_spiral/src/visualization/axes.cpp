#include "canvas.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <cstdio>

namespace pcl_spiral {
namespace {

constexpr double tick_length = 9.0;     ///< pixels
constexpr double label_distance = 30.0; ///< of a number's middle from its edge
constexpr double title_distance = 58.0; ///< for flat edges
constexpr double steep_title_distance = 88.0;
constexpr double label_room = 85.0;    ///< along the edge for one number
constexpr double shortest_axis = 40.0; ///< seen end on, an edge gets no numbers

/** 1, 2 or 5 times a power of ten, not below \p least. */
double
niceStep(double least)
{
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least)
      return factor * power;
  return 10.0 * power;
}

void
addLabel(vtkRenderer* view, const std::string& text, const Eigen::Vector3d& place, int size)
{
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput(text.c_str());
  label->SetPosition(place.x(), place.y(), place.z());
  vtkTextProperty* const style = label->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetFontSize(size);
  style->SetColor(ink[0], ink[1], ink[2]);
  style->SetJustificationToCentered();
  style->SetVerticalJustificationToCentered();
  view->AddActor(label);
}

} // namespace

void
Canvas::addAxes()
{
  for (int axis = 0; axis < 3; ++axis)
    addAxis(axis);
}

void
Canvas::addAxis(int axis)
{
  // Of the box's four edges along the axis, the one that lies outermost on the screen: below for flat ones,
  // left for steep ones, so that the numbers stand clear of the part.
  const Eigen::Vector3d &low = surface_.low, &high = surface_.high;
  const double length = high[axis] - low[axis];
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
  const Eigen::Vector2d run = onScreen(centre_ + length * along);
  if (run.norm() < shortest_axis)
    return;
  const bool steep = std::abs(run.y()) > std::abs(run.x());
  Eigen::Vector2d outward(-run.y(), run.x());
  outward.normalize();
  if (steep ? outward.x() > 0.0 : outward.y() > 0.0)
    outward = -outward;
  Eigen::Vector3d from = low;
  double farthest = -1e300;
  for (int corner = 0; corner < 4; ++corner) {
    Eigen::Vector3d candidate = low;
    candidate[(axis + 1) % 3] = (corner & 1) ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
    candidate[(axis + 2) % 3] = (corner & 2) ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
    const double distance = onScreen(candidate + 0.5 * length * along).dot(outward);
    if (distance > farthest) {
      farthest = distance;
      from = candidate;
    }
  }

  const Eigen::Vector3d away = millimetresPerPixel() * (outward.x() * right_ + outward.y() * top_);
  std::vector<Polyline> strokes{{from, from + length * along}};
  const double step = niceStep(length * label_room / run.norm());
  for (double value = std::ceil(low[axis] / step - 1e-9) * step; value <= high[axis] + 1e-9 * step;
       value += step) {
    const Eigen::Vector3d at = from + (value - low[axis]) * along;
    strokes.push_back({at, at + tick_length * away});
    char number[32];
    std::snprintf(number, sizeof(number), "%.6g", std::abs(value) < 1e-9 * step ? 0.0 : value);
    addLabel(view_, number, at + label_distance * away, 18);
  }
  addLabel(view_, std::string(1, "xyz"[axis]) + ", mm",
           from + 0.5 * length * along + (steep ? steep_title_distance : title_distance) * away, 20);
  view_->AddActor(lineActor(strokes, false, ink, 1.5f));
}

} // namespace pcl_spiral
