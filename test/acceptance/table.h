// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The printed result of an acceptance case: measured values against limits, with places.
 */
#pragma once

#include "support/checked_path.h"

#include <string>

namespace pcl_spiral::acceptance {

/** Prints rows immediately and counts broken limits. Lengths in mm. */
class Table {
public:
  explicit Table(const std::string& title);
  /** A value without a limit. */
  void note(const std::string& name, double value, const std::string& unit = "mm");
  void note(const std::string& name, const std::string& text);
  /** A value that must not exceed the limit. */
  void atMost(const std::string& name, double value, double limit, const std::string& unit = "mm");
  /** The same, with its place, which is printed if the limit is broken. */
  void atMost(const std::string& name, const test::Place& place, double limit, const std::string& unit = "mm");
  void holds(const std::string& name, bool held, const std::string& text = "");
  int broken() const { return broken_; }

private:
  int broken_ = 0;
};

/** Coordinates, distance to the rim, turn and index, to find the fault in the path. */
std::string text(const test::Place& place);

} // namespace pcl_spiral::acceptance
