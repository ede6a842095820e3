// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How deviations and heights of stock are drawn, on a picture or in the viewer.
 */
#pragma once

#include "sheet.h"

#include <pcl_spiral/visualization/verification_pictures.h>

#include <functional>

namespace pcl_spiral {

/** How a value is drawn. */
struct ValueStyle {
  std::function<float(float)> rank; ///< of two on one place that of the higher rank is seen
  std::function<Color(float)> color;
  std::function<bool(float)> outstanding; ///< drawn larger, to be seen even alone
};

/** The two lines above a view. */
struct Title {
  std::string first, second;
};

/** How the deviations of a scene are drawn. */
class DeviationScale {
public:
  explicit DeviationScale(const DeviationFigures& figures);

  vtkScalarsToColors* colors() const { return colors_; }
  ValueStyle style() const;
  /** \p hidden: whether the part hides the largest one. */
  std::vector<LegendEntry> legend(const VerificationScene& scene, bool hidden) const;

private:
  double reach_; ///< half the range of the colours, mm
  vtkSmartPointer<vtkScalarsToColors> colors_;
};

Title deviationTitle(const VerificationScene& scene);

/** How the heights of stock of a scene are drawn. */
class StockScale {
public:
  explicit StockScale(const VerificationScene& scene);

  vtkScalarsToColors* colors() const { return colors_; }
  ValueStyle style() const;
  /** Per point the ridge next to it, the stock itself where there is none, or a gouge. */
  std::vector<float> heights(const VerificationScene& scene) const;
  std::vector<LegendEntry> legend(const std::vector<float>& heights) const;

private:
  bool isGouge(float v) const;
  bool isUncut(float v) const;
  bool isAbove(float v) const;
  double gouge_; ///< depth that counts as one
  double limit_, reach_;
  vtkSmartPointer<vtkScalarsToColors> colors_;
};

/** A place that a map of the stock points out. */
struct WorstStock {
  int slot; ///< of two: 0 what is too deep, 1 what is too high
  PlacedValue value;
  std::string name;

  LegendEntry legend(bool hidden) const;
};

/** The deepest gouge, and an uncut place or else the highest ridge, as far as there are any. */
std::vector<WorstStock> worstStock(const RemovalFigures& figures);

Title stockTitle(const VerificationScene& scene);

} // namespace pcl_spiral
