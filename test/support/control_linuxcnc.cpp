// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_iso.h"

#include <algorithm>

namespace pcl_spiral::test {
namespace {

/** LinuxCNC 2.9: G43 counts the length of the tool in the spindle; tool-tip kinematics are switched by two remapped words. */
class LinuxCNC : public IsoLanguage {
public:
  using IsoLanguage::IsoLanguage;

  void run(const std::string& line) override
  {
    if (line.size() > 255)
      throw ControlFault("longer than 255 characters");
    if (line == control_.job().kinematics_on || line == control_.job().kinematics_off) {
      control_.setToolTip(line == control_.job().kinematics_on);
      return;
    }
    ControlWords words = ControlWords::letters(line);
    takeCodes(words, groups());
    if (codeOf("path") == "64" && !words.value("P"))
      throw ControlFault("G64 without P rounds corners without limit");
    runModes();
    runFeed(words);
    runTool(words);
    if (has("43")) {
      if (const auto h = words.value("H"))
        control_.requireLengthOf(static_cast<int>(*h));
      if (control_.job().tool != control_.modal.tool)
        throw ControlFault("G43 before the tool is called");
    }
    if (const std::string length = codeOf("length"); !length.empty())
      control_.modal.length = length == "43";
    runOffset();
    MotionWords motion = placeOf(words);
    motion.machine_frame = has("53");
    words.requireNone();
    if (motion.machine_frame && codeOf("motion").empty())
      throw ControlFault("G53 without G0 or G1");
    runMotion(motion);
    runEnd();
  }

private:
  static const std::map<std::string, std::string>& groups()
  {
    static const std::map<std::string, std::string> all = {
        {"0", "motion"},    {"1", "motion"},    {"80", "motion"}, {"17", "plane"},  {"20", "units"},  {"21", "units"},
        {"40", "side"},     {"43", "length"},   {"49", "length"}, {"53", "frame"},  {"54", "offset"}, {"55", "offset"},
        {"56", "offset"},   {"57", "offset"},   {"58", "offset"}, {"59", "offset"}, {"61", "path"},   {"64", "path"},
        {"90", "distance"}, {"91", "distance"}, {"93", "feed"},   {"94", "feed"}};
    return all;
  }
};

} // namespace

std::unique_ptr<ControlLanguage>
linuxCNC(Control& control)
{
  return std::make_unique<LinuxCNC>(control);
}

} // namespace pcl_spiral::test
