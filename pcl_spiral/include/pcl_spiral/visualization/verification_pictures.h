/** \file
 *  Pictures of how well a toolpath fits its part, made without a window.
 */
#pragma once

#include <pcl_spiral/verify/impl/path_deviation.h>
#include <pcl_spiral/verify/impl/removed_material.h>
#include <pcl_spiral/visualization/pictures.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** What the pictures show; lengths in mm. Values come as DeviationEstimation and MaterialRemoval give them.
 */
struct VerificationScene {
  PictureScene part;            ///< its cloud is the reference; of its report the loops alone are used
  std::vector<float> deviation; ///< one a path point, NaN: not measured
  std::vector<float> stock;     ///< one a reference point, negative: gouge, NaN: no part of the surface
  std::vector<float> ridges;    ///< one a reference point, NaN: none
  DeviationFigures deviation_figures;
  RemovalFigures removal_figures; ///< the scene's chord error and scallop are those it was judged by
};

struct DisplaySurface;

/** The pictures of one verification, each a PNG of 1600 x 1200. Where several values fall on one place of a
 * picture it shows the worst of them, and the worst place of all is enlarged at the side. The same scene
 * gives the same bytes. */
class VerificationPictures {
public:
  /** Thins and triangulates the reference for drawing.
   *  \throw std::invalid_argument where values are given but not one a point, or without a path */
  explicit VerificationPictures(VerificationScene scene);
  ~VerificationPictures();

  /** The path coloured by its signed deviation over the gray surface. The colours reach to twice the 99th
   * percentile of the amount; what lies beyond has colours of its own. \throw std::runtime_error without a
   * display, FileError where the file cannot be written, std::logic_error without deviations */
  void writeDeviation(const std::string& file) const;

  /** The reference points coloured by the stock left: the height of the ridge next to each, its own where
   * there is none. Gouges deeper than the chord error (and than three times the noise of the fit), stock
   * above the limit and uncut places have colours of their own. Errors as for writeDeviation, without stock.
   */
  void writeStock(const std::string& file) const;

  /** How many ridges have which height, on a logarithmic scale, with the scallop asked for and the limit as
   * lines; where none was measured, words that say so. Errors as for writeDeviation, without ridges. */
  void writeHistogram(const std::string& file) const;

private:
  VerificationScene scene_;
  std::unique_ptr<DisplaySurface> surface_;
};

} // namespace pcl_spiral
