// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Figures of a judgement in words for people.
 */
#pragma once

#include "verify/figure_table.h"

namespace pcl_spiral {

/** How an output writes figures. */
struct FigureWriting {
  bool signs = false;              ///< whether the style's signs are written
  const char* degree = " degrees"; ///< behind the number
};

/** The number alone: "0.0123". */
std::string numberText(const Figure& figure, const FigureWriting& writing);

/** The unit as it follows the number: " mm"; empty without a unit. */
std::string unitSuffix(const Figure& figure, const FigureWriting& writing);

/** The place as it follows a value: " at (12.500, -3.000, 0.125), path point 17", or ", first at (...), path point 17" if it is the first
 *  of many. "line 17" instead if the figure is placed by line. Empty if there is no place. */
std::string placeSuffix(const Figure& figure);

/** \p words with the figures that they name by key: "{key}" becomes number and unit, "{#key}" the number alone, "{@key}" the place
 *  (see placeSuffix). \throw std::out_of_range if there is no such figure */
std::string filled(const std::string& words, const FigureTable& table, const FigureWriting& writing = {});

/** Whether all figures that \p words name are known. \throw std::out_of_range if there is no such figure */
bool allKnown(const std::string& words, const FigureTable& table);

} // namespace pcl_spiral
