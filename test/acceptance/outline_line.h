// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A row of the table of outlines: every figure with its limit, and the places of broken limits.
 */
#pragma once

#include "outline_rows.h"

#include "support/path_judge.h"

#include <string>

namespace pcl_spiral::acceptance {

/** The names of the columns. */
std::string outlineHeading();

/** A judged path as one line; a star marks a figure beyond its limit. */
struct OutlineLine {
  std::string line;
  std::string broken; ///< broken limits, by how much and where; empty if every limit holds
  std::string places; ///< of every figure, held or not
};
OutlineLine outlineLine(const OutlineRow& row, const test::JudgedReport& figures, const test::JudgeSettings& settings);

} // namespace pcl_spiral::acceptance
