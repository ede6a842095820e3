// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Styles for deviations and heights of stock, in a picture or in the viewer.
 */
#pragma once

#include "sheet.h"

#include <pcl_spiral/visualization/verification_pictures.h>

#include <functional>

namespace pcl_spiral {

/** Style of a value. */
struct ValueStyle {
  std::function<float(float)> rank; ///< of two values at one place, the one of the higher rank is visible
  std::function<Color(float)> color;
  std::function<bool(float)> outstanding; ///< drawn larger, so that even a single one is visible
};

/** The two lines above a view. */
struct Title {
  std::string first, second;
};

/** Style of the deviations of a scene. */
class DeviationScale {
public:
  explicit DeviationScale(const DeviationReport& figures);

  vtkScalarsToColors* colors() const { return colors_; }
  ValueStyle style() const;
  /** \p hidden: whether the part hides the largest one. */
  std::vector<LegendEntry> legend(const VerificationScene& scene, bool hidden) const;

private:
  double reach_; ///< half the range of the colour scale, mm
  vtkSmartPointer<vtkScalarsToColors> colors_;
};

Title deviationTitle(const VerificationScene& scene);

/** Style of the heights of stock of a scene. */
class StockScale {
public:
  explicit StockScale(const VerificationScene& scene);

  vtkScalarsToColors* colors() const { return colors_; }
  ValueStyle style() const;
  /** For each point: the ridge next to it, the stock if there is no ridge, or a gouge. */
  std::vector<float> heights(const VerificationScene& scene) const;
  std::vector<LegendEntry> legend(const std::vector<float>& heights) const;

private:
  bool isGouge(float v) const;
  bool isUncut(float v) const;
  bool isAbove(float v) const;
  double gouge_; ///< least depth of a gouge
  double limit_, reach_;
  vtkSmartPointer<vtkScalarsToColors> colors_;
};

/** A place marked in a map of the stock. */
struct WorstStock {
  int slot; ///< of two: 0 too deep, 1 too high
  PlacedValue value;
  std::string name;

  LegendEntry legend(bool hidden) const;
};

/** The deepest gouge, and an uncut place or otherwise the highest ridge, if there are any. */
std::vector<WorstStock> worstStock(const RemovalReport& figures);

Title stockTitle(const VerificationScene& scene);

} // namespace pcl_spiral
