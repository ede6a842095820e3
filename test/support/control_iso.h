// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the languages of G-codes have in common.
 */
#pragma once

#include "support/control_languages.h"

namespace pcl_spiral::test {

/** G-codes of one line by group, motion and feed kept from line to line. */
class IsoLanguage : public ControlLanguage {
public:
  using ControlLanguage::ControlLanguage;

protected:
  /** Takes all G-codes; a code that \p groups does not have, or two of a group, is a fault. */
  void takeCodes(ControlWords& words, const std::map<std::string, std::string>& groups);
  bool has(const std::string& code) const;
  /** The code of a group in this line; empty: none. */
  std::string codeOf(const std::string& group) const;

  void runModes();                   ///< units, plane, absolute, feed mode, motion
  void runFeed(ControlWords& words); ///< F, before the motion
  void runTool(ControlWords& words); ///< S, T, M6, spindle, coolant
  void runOffset();                  ///< G54 to G59
  /** The motion of the line, if it has one. */
  void runMotion(MotionWords motion);
  void runEnd();

  std::vector<int> codes_m_; ///< of the line, those not run yet

private:
  std::map<std::string, std::string> codes_; ///< group and code of the line
  std::string motion_;                       ///< G0, G1 or none, modal
  std::optional<double> feed_, inverse_;     ///< mm/min, modal; 1/min, of the line
};

} // namespace pcl_spiral::test
