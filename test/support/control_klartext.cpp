// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_languages.h"

#include <cmath>
#include <regex>

namespace pcl_spiral::test {
namespace {

/** Heidenhain TNC: numbered lines; TOOL CALL sets speed and length; M128 keeps the tip; F is the speed of the tip, FMAX and
 *  FT hold for their line alone. */
class Klartext : public ControlLanguage {
public:
  explicit Klartext(Control& control) : ControlLanguage(control)
  {
    ModalState& modal = control_.modal;
    modal.absolute = modal.plane_xy = modal.feed_mode = true;
    modal.length = control_.job().tool == 0;      // of the tool that was called before
    modal.offset = control_.job().offset.empty(); // the active preset
  }

  void run(const std::string& line) override
  {
    static const std::regex frame("(BEGIN|END) PGM ([A-Za-z0-9_-]+) (MM|INCH)"), tool("TOOL CALL(?: ([0-9]+))? Z(?: S([0-9]+))?"),
        code("M([0-9]+)"), motion("(LN?) (.*)");
    std::smatch parts;
    if (std::regex_match(line, parts, frame))
      runFrame(parts);
    else if (name_.empty())
      throw ControlFault("before BEGIN PGM");
    else if (std::regex_match(line, parts, tool))
      runTool(parts);
    else if (line.rfind("CYCL DEF ", 0) == 0)
      runCycle(line.substr(9));
    else if (std::regex_match(line, parts, code))
      runCode(std::stoi(parts[1]));
    else if (std::regex_match(line, parts, motion))
      runLine(parts[1] == "LN", parts[2]);
    else
      throw ControlFault("unknown line");
  }

  void end() override
  {
    if (!closed_)
      throw ControlFault("no END PGM");
  }

private:
  void runFrame(const std::smatch& parts)
  {
    if (closed_ || (parts[1] == "BEGIN") != name_.empty() || (parts[1] == "END" && parts[2] != name_))
      throw ControlFault("not the begin or the end of this program");
    control_.requireMetric(parts[3] == "MM");
    closed_ = parts[1] == "END";
    name_ = parts[2];
  }

  void runTool(const std::smatch& parts)
  {
    if (parts[1].matched) {
      control_.callTool(std::stoi(parts[1]));
      control_.modal.length = true;
    }
    if (parts[2].matched)
      control_.modal.spindle_speed = std::stoi(parts[2]);
  }

  void runCycle(const std::string& text)
  {
    std::smatch parts;
    if (std::regex_match(text, parts, std::regex("247 .*Q339=\\+?([0-9]+).*")))
      control_.chooseOffset(parts[1]);
    else if (std::regex_match(text, parts, std::regex("32\\.1( T([0-9.]+))?")))
      control_.modal.smoothing = parts[1].matched && std::stod(parts[2]) > 0.0;
    else if (text != "32.0 TOLERANCE" && !std::regex_match(text, std::regex("32\\.2 HSC-MODE:[01]( TA[0-9.]+)?")))
      throw ControlFault("unknown cycle");
  }

  void runCode(int code)
  {
    if (code == 128 || code == 129)
      control_.setToolTip(code == 128, true);
    else if (code == 30 || code == 2)
      control_.modal.ended = true;
    else if (!runCommonCode(code))
      throw ControlFault("unknown word M" + std::to_string(code));
  }

  void runLine(bool normal, const std::string& text)
  {
    ControlWords words = ControlWords::spaced(text);
    MotionWords motion = placeOf(words);
    const auto surface = words.vector({"NX", "NY", "NZ"});
    motion.vector = words.vector({"TX", "TY", "TZ"});
    if (normal != surface.has_value())
      throw ControlFault("a surface normal belongs to LN");
    if (const auto r = words.value("R"); r && *r != 0.0)
      throw ControlFault("radius compensation");
    const auto code = words.value("M");
    if (code && *code != 91.0)
      throw ControlFault("unknown word M in a line");
    motion.machine_frame = code.has_value();
    const bool rapid = words.take("FMAX").has_value();
    const auto seconds = words.value("FT"), feed = words.value("F");
    if (rapid + seconds.has_value() + feed.has_value() > 1)
      throw ControlFault("two feeds in a line");
    words.requireNone();
    feed_ = feed ? feed : feed_;
    motion.feed = feed_;
    if (seconds)
      motion.minutes = *seconds / 60.0;
    control_.move(motion, rapid);
  }

  std::string name_;
  bool closed_ = false;
  std::optional<double> feed_;
};

} // namespace

std::unique_ptr<ControlLanguage>
klartext(Control& control)
{
  return std::make_unique<Klartext>(control);
}

} // namespace pcl_spiral::test
