// SPDX-License-Identifier: BSD-3-Clause
#include "control_program.h"
#include "program_track.h"
#include "text_scan.h"

#include "io/link_marks.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace pcl_spiral {
namespace {

/** Statements that do not move the tool. */
constexpr const char* silent[] = {"partno", "multax", "cutter", "spindl", "pprint", "intol",   "outtol", "toler",
                                  "loadtl", "toolno", "coolnt", "remark", "tprint", "display", "machin", "clprnt"};

class AptReader {
public:
  AptReader(const std::string& file, std::string_view text, const Machine& machine)
  : file_(file), lines_(text), machine_(machine), track_(machine, false)
  {}

  ProgramFile read()
  {
    if (!machine_.rtcp)
      fail("APT has tips, but the machine file has rtcp: false; read it without a machine, or set rtcp: true");
    std::string_view line;
    while (!ended_ && lines_.next(line))
      if (line.substr(0, 2) == "$$")
        in_link_ = isInLink(trimmed(line.substr(2)), in_link_);
      else if (!line.empty())
        takeLine(line);
    if (!ended_)
      fail("the file ends without FINI: it was cut off; write it again");
    if (!track_.begun())
      fail("the file has no GOTO; write it again");
    return track_.take();
  }

private:
  [[noreturn]] void fail(const Diagnostic& reason) const { throw FileError(file_, atLine(lines_.number(), reason)); }

  void takeLine(std::string_view line)
  {
    const std::size_t slash = line.find('/');
    const std::string_view word = trimmed(line.substr(0, std::min(slash, line.find(' '))));
    splitWords(slash == std::string_view::npos ? std::string_view() : line.substr(slash + 1), ',', values_);
    if (sameWord(word, "goto") || sameWord(word, "from"))
      takeGoto(sameWord(word, "from"));
    else if (sameWord(word, "rapid"))
      rapid_ = true;
    else if (sameWord(word, "fedrat"))
      takeFeed();
    else if (sameWord(word, "units"))
      unit_ = sameWord(values_[0], "mm") ? 1.0 : sameWord(values_[0], "inches") ? 25.4 : refuseUnit(line);
    else if (sameWord(word, "fini") || sameWord(word, "end"))
      ended_ = true;
    else if (std::none_of(std::begin(silent), std::end(silent), [&](const char* name) { return sameWord(word, name); }))
      fail(Diagnostic(
          inQuotes(word),
          " is not understood: GOTO, RAPID, FEDRAT and UNITS are followed; write every move as GOTO with tip and axis, and leave "
          "the word out if it does not move the tool"));
  }

  double refuseUnit(std::string_view line) const { fail(Diagnostic(inQuotes(line), " is not a unit; write UNITS/MM or UNITS/INCHES")); }

  double number(std::size_t i) const
  {
    const std::optional<double> value = toNumber(values_[i]);
    if (!value)
      fail(Diagnostic(inQuotes(values_[i]), " is not a number; write it as 12.5"));
    return *value;
  }

  void takeFeed()
  {
    if (values_.size() > 1 && !sameWord(values_[1], "mmpm") && !sameWord(values_[1], "ipm"))
      fail(Diagnostic(inQuotes(values_[1]), " is not a unit of the feed that is understood; write FEDRAT/1000.0,MMPM"));
    feed_ = number(0) * (values_.size() > 1 && sameWord(values_[1], "ipm") ? 25.4 : 1.0);
  }

  void takeGoto(bool from)
  {
    if (values_.size() != 3 && values_.size() != 6)
      fail(Diagnostic("a GOTO has ", values_.size(), " values; write X,Y,Z or X,Y,Z,I,J,K"));
    ProgramTarget target;
    for (std::size_t i = 0; i < 3; ++i)
      target.xyz[i] = unit_ * number(i);
    if (values_.size() == 6)
      axis_ = {number(3), number(4), number(5)};
    if (!(axis_.norm() > 1e-6))
      fail("the tool axis of the GOTO has no length; write its direction");
    target.axis = axis_.normalized();
    target.of_tip = true;
    target.rapid = rapid_ || from || !track_.begun();
    target.link = in_link_;
    target.feed = feed_ > 0.0 ? feed_ : 1.0; // a path without FEDRAT has no times
    rapid_ = false;
    if (const Diagnostic fault = track_.move(lines_.number(), target); !fault.empty())
      fail(fault);
  }

  std::string file_;
  LineScanner lines_;
  const Machine& machine_;
  ProgramTrack track_;
  std::vector<std::string_view> values_;
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
  double unit_ = 1.0, feed_ = 0.0;
  bool rapid_ = false, ended_ = false, in_link_ = false;
};

} // namespace

ProgramFile
readAPT(const std::string& file, std::string_view text, const Machine& machine, bool has_machine)
{
  ProgramFile result = AptReader(file, text, machine).read();
  result.axis_arcs = !has_machine;
  return result;
}

} // namespace pcl_spiral
