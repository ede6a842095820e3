/** \file
 *  A picture in the making: camera, axes, words, and the PNG at the end.
 */
#pragma once

#include "display_surface.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/visualization/box_axes.h>

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

/** How a place on the part is pointed out: a ring means that the part hides it. */
enum class Marker { Disc, Ring, Square };

/** An entry of the legend. */
struct LegendEntry {
  std::string text;
  Color color;
  Marker marker = Marker::Square;
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
  const ParallelView&
  projection() const
  {
    return projection_;
  }

  void addTitle(const std::string& first, const std::string& second);
  /** Draw what lies on the surface: nearer to the viewer by what the drawn surface may stand out. */
  void addOver(vtkActor* actor);
  /** Draw over everything, what the part hides too. */
  void addInFront(vtkActor* actor);
  /** A mark over everything: a ring where the part hides the place. Returns whether it does. */
  bool addMarker(const Eigen::Vector3d& place, const Color& color);
  /** Axes with numbers in mm, clear of the part and of one another. */
  void addAxes();
  void addLegend(const std::vector<LegendEntry>& entries);
  void addColorBar(const std::string& title, const char* format, vtkScalarsToColors* colors);
  /** An enlarged view, \p across mm wide and high, along \p normal; the \p slot'th from the top of two. */
  vtkSmartPointer<vtkRenderer> addInset(int slot, const Eigen::Vector3d& centre,
                                        const Eigen::Vector3d& normal, double across);
  /** \throw FileError */
  void save(const std::string& file);

  static constexpr int width = 1600;
  static constexpr int height = 1200;
  static constexpr int inset_size = 386;

private:
  void aim();
  /** Where a place appears: pixels from the lower left corner. */
  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const;

  const DisplaySurface& surface_;
  ParallelView projection_;
  Eigen::Vector2d origin_; ///< where the scene's origin appears, pixels
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> view_;
};

/** Words at a place of a view, from its lower left corner in pixels. */
void addText(vtkRenderer* view, const std::string& text, int x, int y, int size, bool bold = false);

/** Words about a place of a view; pixels. */
void addCentredText(vtkRenderer* view, const std::string& text, const Eigen::Vector2d& middle, int size);

/** The surface in one colour, lit from the viewer's side. */
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface, const Color& color);

/** Straight strokes in a view, drawn over everything else; pixels. */
void addStrokes(vtkRenderer* view, const std::vector<std::array<Eigen::Vector2d, 2>>& strokes,
                const Color& color, float width);

/** Lines in one colour, drawn over the surface they lie on. */
vtkSmartPointer<vtkActor> lineActor(const std::vector<Polyline>& lines, bool closed, const Color& color,
                                    float width);

/** A mark in a view, drawn over everything else; pixels from the view's lower left corner. */
void addMark(vtkRenderer* view, Marker marker, const Eigen::Vector2d& place, const Color& color);

/** From dark blue through green to yellow. */
vtkSmartPointer<vtkScalarsToColors> colorScale(double low, double high);

} // namespace pcl_spiral
