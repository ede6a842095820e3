// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_iso.h"

#include <regex>

namespace pcl_spiral::test {
namespace {

/** Sinumerik 840D: D1 counts the tool length, SUPA moves in the machine's frame, TRAORI keeps the tip, ORIVECT turns the
 *  tool in one plane. */
class Siemens : public IsoLanguage {
public:
  using IsoLanguage::IsoLanguage;

  void run(const std::string& line) override
  {
    if (runName(line))
      return;
    ControlWords words = ControlWords::spaced(line);
    takeCodes(words, groups());
    runModes();
    runFeed(words);
    runTool(words);
    runOffset();
    if (const auto d = words.value("D")) {
      if (*d != 0.0 && *d != 1.0)
        throw ControlFault("the tool has D1 alone");
      control_.modal.length = *d == 1.0;
    }
    MotionWords motion = placeOf(words);
    motion.machine_frame = words.take("SUPA").has_value();
    if (motion.machine_frame && control_.modal.length)
      throw ControlFault("SUPA with the tool length on; D0 is missing");
    motion.vector = words.vector({"A3", "B3", "C3"});
    motion.great_circle = true;
    if (motion.vector && (!work_frame_ || !vectors_))
      throw ControlFault("a tool vector without ORIWKS and ORIVECT");
    words.requireNone();
    runMotion(motion);
    runEnd();
  }

private:
  /** A line of one name. */
  bool runName(const std::string& line)
  {
    static const std::regex tolerance("CYCLE832\\(0*\\.[0-9]*[1-9][0-9]*,_ORI_(FINISH|ROUGH|SEMIFIN),[0-9.]+\\)");
    if (line == "TRAORI" || line == "TRAFOOF")
      control_.setToolTip(line == "TRAORI", true);
    else if (line == "ORIWKS")
      work_frame_ = true;
    else if (line == "ORIVECT")
      vectors_ = true;
    else if (std::regex_match(line, tolerance))
      control_.modal.smoothing = true;
    else if (line == "CYCLE832(0,_OFF,1)")
      control_.modal.smoothing = false;
    else
      return false;
    return true;
  }

  static const std::map<std::string, std::string>& groups()
  {
    static const std::map<std::string, std::string> all = {
        {"0", "motion"},  {"1", "motion"},  {"17", "plane"},  {"70", "units"},    {"71", "units"},    {"40", "side"}, {"54", "offset"},
        {"55", "offset"}, {"56", "offset"}, {"57", "offset"}, {"90", "distance"}, {"91", "distance"}, {"93", "feed"}, {"94", "feed"}};
    return all;
  }

  bool work_frame_ = false, vectors_ = false;
};

} // namespace

std::unique_ptr<ControlLanguage>
siemens(Control& control)
{
  return std::make_unique<Siemens>(control);
}

} // namespace pcl_spiral::test
