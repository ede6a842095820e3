/** \file
 *  A picture in the making: camera, axes, words, and the PNG at the end.
 */
#pragma once

#include "display_surface.h"

#include <pcl_spiral/core/polyline.h>

#include <vtkActor.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>

#include <array>
#include <string>
#include <vector>

namespace pcl_spiral {

using Color = std::array<double, 3>;

constexpr Color ink{0.13, 0.15, 0.19};
constexpr Color surface_color{0.80, 0.83, 0.87};

/** An entry of the legend. */
struct LegendEntry {
  std::string text;
  Color color;
};

/** An offscreen window of 1600 x 1200 with one main view. */
class Canvas {
public:
  /** The main view shows the whole of \p surface, along its mean normal tilted by 35 degrees; words go right
   * of it. \throw std::runtime_error without a display */
  explicit Canvas(const DisplaySurface& surface);

  vtkRenderer*
  view()
  {
    return view_;
  }
  vtkRenderWindow*
  window()
  {
    return window_;
  }
  /** Millimetres that one pixel of the main view stands for. */
  double millimetresPerPixel() const;

  void addTitle(const std::string& first, const std::string& second);
  /** Draw what lies on the surface: nearer to the viewer by what the drawn surface may stand out. */
  void addOver(vtkActor* actor);
  /** Edges of the bounding box with numbers in mm. */
  void addAxes();
  void addLegend(const std::vector<LegendEntry>& entries);
  void addColorBar(const std::string& title, const char* format, vtkScalarsToColors* colors);
  /** \throw FileError */
  void save(const std::string& file);

  static constexpr int width = 1600;
  static constexpr int height = 1200;

private:
  void aim();
  void addAxis(int axis);
  /** Where a place appears: pixels right of and above the middle of the box. */
  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const;

  const DisplaySurface& surface_;
  Eigen::Vector3d centre_, right_, top_; ///< middle of the box; directions of the picture
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> view_;
};

/** Words at a place of a view, from its lower left corner in pixels. */
void addText(vtkRenderer* view, const std::string& text, int x, int y, int size, bool bold = false);

/** The surface in one colour, lit from the viewer's side. */
vtkSmartPointer<vtkActor> surfaceActor(const DisplaySurface& surface, const Color& color);

/** Lines in one colour, drawn over the surface they lie on. */
vtkSmartPointer<vtkActor> lineActor(const std::vector<Polyline>& lines, bool closed, const Color& color,
                                    float width);

/** A ball. */
vtkSmartPointer<vtkActor> ballActor(const Eigen::Vector3d& centre, double radius, const Color& color);

/** From dark blue through green to yellow. */
vtkSmartPointer<vtkScalarsToColors> colorScale(double low, double high);

} // namespace pcl_spiral
