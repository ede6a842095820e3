/** \file
 *  Figures of toolpaths judged by a scan, as JSON.
 */
#pragma once

#include <pcl_spiral/io/length_unit.h>
#include <pcl_spiral/verify/path_deviation.h>
#include <pcl_spiral/verify/removed_material.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** A toolpath's figures. */
struct Verification {
  std::string path; ///< file name; empty for one that has just been made
  DeviationFigures deviation;
  RemovalFigures removal;
  std::vector<std::string> broken; ///< limits that do not hold, in words
};

/** What toolpaths were judged by. */
struct VerificationRun {
  std::string scan;
  LengthUnit unit = LengthUnit::Millimetre; ///< of the numbers in the scan
  double tool_radius = 0.0;                 ///< mm
  double scallop_height = 0.0;              ///< mm
  double chord_error = 0.0;                 ///< mm
  std::vector<std::string> warnings;        ///< from reading
};

/** Settings, and deviation, scallop, gouge, uncut share, efficiency and motion of each path with the places of the
 *  worst. Lengths mm, angles degrees, seconds. \throw FileError */
void writeVerificationJSON(const std::string& file, const VerificationRun& run,
                           const std::vector<Verification>& verifications);

} // namespace pcl_spiral
