/** \file
 *  The figures of a path for people, and the limits that it must keep.
 */
#pragma once

#include <pcl_spiral/io/verification_writer.h>

#include <optional>
#include <string>
#include <vector>

/** What a path must keep; absent: anything goes. */
struct Limits {
  std::optional<double> gouge;     ///< mm
  std::optional<double> scallop;   ///< mm
  std::optional<double> deviation; ///< mm
  std::optional<double> uncut;     ///< percent of the reference points
};

/** The limits that do not hold, each with the value found and its place. */
std::vector<std::string> brokenLimits(const Limits& limits, const pcl_spiral::Verification& verification);

void printFigures(const pcl_spiral::Verification& verification);
