// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words of one line of a program.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** G43.4, X-1.5, A3=0.1, TRAORI. */
struct ControlWord {
  std::string name;   ///< before the number
  std::string digits; ///< as written; empty: a word without a number
  double value = 0.0;
};

/** Words of a line; what nobody takes is unknown to the control. Every failure is a ControlFault. */
class ControlWords {
public:
  /** Letters, each with a number; spaces do not matter. */
  static ControlWords letters(const std::string& line);
  /** Words between spaces: a letter or letters with a number, NAME=number, or a name alone. */
  static ControlWords spaced(const std::string& line);

  /** The word \p name, taken out; a fault if it is there twice. */
  std::optional<ControlWord> take(const std::string& name);
  std::optional<double> value(const std::string& name);
  /** All three or none of them. */
  std::optional<Eigen::Vector3d> vector(const std::array<std::string, 3>& names);
  /** Every word of this name, taken out. */
  std::vector<ControlWord> takeAll(const std::string& name);
  const std::vector<ControlWord>& left() const { return words_; }
  /** A fault if words are left. */
  void requireNone() const;

private:
  std::vector<ControlWord> words_;
};

} // namespace pcl_spiral::test
