// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A page of a picture: its window, its words, and the PNG at the end.
 */
#pragma once

#include "common/formatted_text.h"
#include <pcl_spiral/visualization/impl/loop_color.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace pcl_spiral {

constexpr Color ink{0.13, 0.15, 0.19};

/** How a place on the part is pointed out: a ring means that the part hides it; a circle leaves the place to
 * be seen. */
enum class Marker { Disc, Ring, Square, Circle };

/** An entry of the legend. */
struct LegendEntry {
  std::string text;
  Color color;
  Marker marker = Marker::Square;
};

/** The size of a page, pixels, and where its words go: a title above, a column at the right. */
struct PageSize {
  int width = 1600, height = 1200;
  int column_top = height - 70;

  static constexpr int column_width = 386;
  static constexpr int column_room = 410; ///< from the column's left edge to the page's right one
  int wordsLeft() const { return width - column_room; }
};

/** An offscreen window of 1600 x 1200 with one main view; title above, words in a column at the right. */
class Sheet {
public:
  /** \throw std::runtime_error without a display */
  Sheet();

  vtkRenderer* view() { return view_; }
  void addTitle(const std::string& first, const std::string& second);
  void addLegend(const std::vector<LegendEntry>& entries);
  void addColorBar(const std::string& title, vtkScalarsToColors* colors);
  /** \throw FileError */
  void save(const std::string& file);

  static constexpr int width = 1600, height = 1200;
  static constexpr int words_left = width - PageSize::column_room, column_width = PageSize::column_width;

protected:
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> view_;
};

/** The words of a page, in a view that fills it. The legend's entries stand below the colour bar; returns
 * where the next would. */
void addTitle(vtkRenderer* view, const PageSize& page, const std::string& first, const std::string& second);
int addLegend(vtkRenderer* view, const PageSize& page, const std::vector<LegendEntry>& entries);
void addColorBar(vtkRenderer* view, const PageSize& page, const std::string& title, vtkScalarsToColors* colors);

/** What \p window shows, as a PNG. \throw FileError */
void writePNG(vtkRenderWindow* window, const std::string& file);

/** Words at a place of a view, from its lower left corner in pixels; smaller where they would reach beyond the view. */
void addText(vtkRenderer* view, const std::string& text, int x, int y, int size, bool bold = false);

/** Words about a place of a view; pixels. They are at most \p room wide. */
void addCentredText(vtkRenderer* view, const std::string& text, const Eigen::Vector2d& middle, int size,
                    double room = std::numeric_limits<double>::infinity());

/** Straight strokes in a view, drawn over everything else; pixels. */
void addStrokes(vtkRenderer* view, const std::vector<std::array<Eigen::Vector2d, 2>>& strokes, const Color& color, float width);

/** Upright rectangles, each from its lower left to its upper right corner, drawn over everything else;
 * pixels. */
void addBoxes(vtkRenderer* view, const std::vector<std::array<Eigen::Vector2d, 2>>& boxes, const Color& color);

/** A mark in a view, drawn over everything else; pixels from the view's lower left corner. */
void addMark(vtkRenderer* view, Marker marker, const Eigen::Vector2d& place, const Color& color);

} // namespace pcl_spiral
