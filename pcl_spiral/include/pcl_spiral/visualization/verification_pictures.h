// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pictures of how well a toolpath fits its part, made without a window.
 */
#pragma once

#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/visualization/pictures.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Contents of the pictures; lengths in mm. Values as
 *  DeviationEstimation and MaterialRemoval give them. */
struct VerificationScene {
  PictureScene part;                 ///< its cloud is the reference; of its report only the loops are used
  std::vector<float> deviation;      ///< one per path point; NaN: not measured
  std::vector<float> stock;          ///< one per reference point; negative: gouge; NaN: not part of the surface
  std::vector<float> ridges;         ///< one per reference point; NaN: none
  DeviationReport deviation_figures; ///< of the deviations
  RemovalReport removal_figures;     ///< the chord error and scallop height of the scene are those by which it was judged
};

struct DisplaySurface;

/** The pictures of one verification, each a PNG of 1600 x 1200. If several values
 *  fall on one place of a picture, it shows the worst of them. The worst place
 *  of all is enlarged at the side. The same scene gives the same bytes. */
class VerificationPictures {
public:
  /** Thins and triangulates the reference for drawing.
   *  \throw std::invalid_argument if values are given but are not one per point, or without a path */
  explicit VerificationPictures(VerificationScene scene);
  ~VerificationPictures();

  /** The path coloured by its signed deviation over the gray surface. The colour scale ends at twice the 99th
   *  percentile of the absolute value; values beyond have colours of their own. \throw std::runtime_error
   *  without a display, FileError if the file cannot be written, std::logic_error without deviations */
  void writeDeviation(const std::string& file) const;

  /** The reference points coloured by the stock left: the height of the ridge next to each
   *  point, or its own stock if there is no ridge. Gouges deeper than the chord error (and
   *  than three times the noise of the fit), stock above the limit and uncut places have
   *  colours of their own. Errors as for writeDeviation, if there is no stock. */
  void writeStock(const std::string& file) const;

  /** The number of ridges of each height, on a logarithmic scale, with lines at the scallop height asked for and at
   *  the limit. If no ridge was measured, a text says so. Errors as for writeDeviation, if there are no ridges. */
  void writeHistogram(const std::string& file) const;

private:
  VerificationScene scene_;
  std::unique_ptr<DisplaySurface> surface_;
};

} // namespace pcl_spiral
