// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The languages of the controls of the tests: what the words of a line change.
 */
#pragma once

#include "support/control_state.h"
#include "support/control_words.h"

#include <memory>
#include <string>

namespace pcl_spiral::test {

/** Reads a program line by line. */
class ControlLanguage {
public:
  explicit ControlLanguage(Control& control) : control_(control) {}
  virtual ~ControlLanguage() = default;
  ControlLanguage(const ControlLanguage&) = delete;
  ControlLanguage& operator=(const ControlLanguage&) = delete;

  /** \p line without its number and comments; \throw ControlFault */
  virtual void run(const std::string& line) = 0;
  virtual void end() {} ///< the text is at its end

protected:
  /** Codes of M that every control has: spindle, coolant, end. */
  bool runCommonCode(int code);
  /** X Y Z and the rotary axes. */
  MotionWords placeOf(ControlWords& words) const;

  Control& control_;
};

std::unique_ptr<ControlLanguage> linuxCNC(Control& control);
std::unique_ptr<ControlLanguage> fanuc(Control& control);
std::unique_ptr<ControlLanguage> siemens(Control& control);
std::unique_ptr<ControlLanguage> klartext(Control& control);

} // namespace pcl_spiral::test
