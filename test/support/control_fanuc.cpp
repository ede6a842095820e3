// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_iso.h"

#include <regex>

namespace pcl_spiral::test {
namespace {

/** Fanuc 30i: G43.4 and G43.5 are tool centre point control with angles and with vectors; axis words without a point
 *  count in thousandths on many machines. */
class Fanuc : public IsoLanguage {
public:
  using IsoLanguage::IsoLanguage;

  void run(const std::string& line) override
  {
    if (line == "%") {
      ++marks_;
      return;
    }
    if (marks_ != 1)
      throw ControlFault("outside of %");
    static const std::regex name("O[0-9]{4}");
    if (std::regex_match(line, name)) {
      named_ = true;
      return;
    }
    if (!named_)
      throw ControlFault("before the number O of the program");
    runWords(line);
  }

  void end() override
  {
    if (marks_ != 2)
      throw ControlFault("no % at the end");
  }

private:
  void runWords(const std::string& line)
  {
    ControlWords words = ControlWords::letters(line);
    for (const ControlWord& word : words.left())
      if (std::string("XYZABCIJK").find(word.name) != std::string::npos && word.digits.find('.') == std::string::npos)
        throw ControlFault(word.name + word.digits + " without a point is in thousandths");
    takeCodes(words, groups());
    runModes();
    runFeed(words);
    runTool(words);
    runSmoothing(words);
    runOffset();
    runLength(words);
    MotionWords motion = placeOf(words);
    motion.vector = words.vector({"I", "J", "K"});
    motion.machine_frame = has("53");
    words.requireNone();
    runMotion(motion);
    runEnd();
  }

  void runSmoothing(ControlWords& words)
  {
    const std::string code = codeOf("smoothing");
    if (code.empty())
      return;
    const auto on = words.value(code == "8" ? "P" : "Q");
    if (!on || (*on != 0.0 && *on != 1.0))
      throw ControlFault("G" + code + " without 0 or 1");
    control_.modal.smoothing = *on == 1.0;
  }

  void runLength(ControlWords& words)
  {
    const std::string code = codeOf("length");
    if (code.empty())
      return;
    control_.modal.length = code != "49";
    if (code == "49") {
      control_.setToolTip(false);
      return;
    }
    const auto h = words.value("H");
    if (!h)
      throw ControlFault("G" + code + " without H");
    control_.requireLengthOf(static_cast<int>(*h));
    if (code != "43")
      control_.setToolTip(true, code == "43.5");
  }

  static const std::map<std::string, std::string>& groups()
  {
    static const std::map<std::string, std::string> all = {
        {"0", "motion"},    {"1", "motion"},    {"80", "cycle"},    {"17", "plane"},    {"20", "units"},      {"21", "units"},
        {"40", "side"},     {"43", "length"},   {"43.4", "length"}, {"43.5", "length"}, {"49", "length"},     {"53", "frame"},
        {"54", "offset"},   {"55", "offset"},   {"56", "offset"},   {"57", "offset"},   {"58", "offset"},     {"59", "offset"},
        {"90", "distance"}, {"91", "distance"}, {"93", "feed"},     {"94", "feed"},     {"5.1", "smoothing"}, {"8", "smoothing"}};
    return all;
  }

  int marks_ = 0;
  bool named_ = false;
};

} // namespace

std::unique_ptr<ControlLanguage>
fanuc(Control& control)
{
  return std::make_unique<Fanuc>(control);
}

} // namespace pcl_spiral::test
