// SPDX-License-Identifier: BSD-3-Clause
#include "control_program.h"
#include "known_lines.h"
#include "program_track.h"
#include "program_words.h"

#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

namespace pcl_spiral {
namespace {

class KlartextReader {
public:
  KlartextReader(const std::string& file, std::string_view text, const Machine& machine)
  : lines_(file, text), machine_(machine), track_(machine, false)
  {}

  ProgramFile read()
  {
    while (!ended_ && lines_.next())
      takeLine();
    if (!ended_)
      lines_.fail("the program ends without END PGM: it was cut off; write it again");
    if (!track_.begun())
      lines_.fail("the program has no place with all five axes; name X Y Z and TX TY TZ in one LN");
    ProgramFile result = track_.take();
    result.still_line = still_line_;
    return result;
  }

private:
  void takeLine()
  {
    const std::vector<ProgramWord>& words = lines_.words();
    if (!words.front().name.empty() || !words.front().value)
      lines_.fail(words.front(), "a line of Klartext begins with its number; write it");
    const double number = *words.front().value;
    if (number != next_)
      lines_.fail(Diagnostic("the line has the number ", wholeNumber(number), ", and ", wholeNumber(next_),
                             " follows: a block is missing; write the program again"));
    next_ = number + 1.0;
    if (words.size() == 1 || isShopLine(machine_, lineWithoutNumber(lines_.text())))
      return; // only a comment, or a line of the shop
    const std::string& first = words[1].name;
    if (first == "BEGIN")
      takeBegin();
    else if (first == "END")
      ended_ = true;
    else if (first == "L" || first == "LN")
      takeMove();
    else if (first == "M")
      takeSwitches();
    else if (first == "CYCL")
      takeCycle();
    else if (first == "TOOL") {
      if (track_.begun())
        lines_.fail("another tool is called; judge one program for each tool");
    }
    else
      lines_.fail(words[1], "not a line that is understood: straight moves (L, LN), M, TOOL CALL; write straight moves");
  }

  void takeBegin()
  {
    const std::string_view text = lines_.text();
    if (text.size() > 5 && text.substr(text.size() - 5) == " INCH")
      unit_ = 25.4;
  }

  /** The tolerance (32) and the preset (247): neither moves the tool. */
  void takeCycle()
  {
    const std::vector<ProgramWord>& words = lines_.words();
    const double number = words.size() > 2 && words[2].name == "DEF" ? std::floor(words[2].value.value_or(0.0)) : 0.0;
    if (number != 32.0 && number != 247.0)
      lines_.fail(words[1], "a cycle; write straight moves (L, LN)");
    if (number == 247.0 && track_.begun())
      lines_.fail(words[1], "another preset; judge one program for each preset");
  }

  /** A line of M codes, some with a value such as P0. */
  void takeSwitches()
  {
    const std::vector<ProgramWord>& words = lines_.words();
    for (std::size_t i = 1; i < words.size(); ++i)
      if (words[i].name != "P" && words[i].name != "Q")
        takeM(words[i]);
  }

  void takeM(const ProgramWord& word)
  {
    const int code = word.name == "M" && word.value ? static_cast<int>(std::lround(*word.value)) : -1;
    if (code < 0)
      return lines_.fail(word, "not a word that is understood; leave it out if it does not move the tool");
    if (code == 3 || code == 4 || code == 5 || code == 13 || code == 14)
      spindle_ = code != 5;
    else if (code == 128 || code == 129)
      guides_tip_ = code == 128;
    else if (code == 91)
      of_machine_ = true;
    else if (code == 92 || code == 98 || code == 99 || code == 130)
      lines_.fail(word, "other coordinates, or a call; write straight moves of the tip with M128");
  }

  /** Of F, mm: in inch programs it is in tenths of an inch a minute (iTNC 530, 60642x-03, M116). */
  double feedUnit() const { return unit_ > 1.0 ? 0.1 * unit_ : unit_; }

  void takeMove()
  {
    of_machine_ = false;
    ProgramTarget target;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    const std::vector<ProgramWord>& words = lines_.words();
    for (std::size_t i = 2; i < words.size(); ++i)
      takeWord(words[i], target, axis);
    if (axis.norm() > 1e-6)
      target.axis = axis.normalized();
    if (!target.names())
      return;
    target.of_machine = of_machine_;
    target.of_tip = guides_tip_;
    const bool over_first = target.rapid && !target.xyz[2]; // X, Y and rotary axes alone, at the height of the retract
    if (!of_machine_ && !guides_tip_ && machine_.takesTips() && !over_first)
      lines_.fail("M128 is not on, and the control would not keep the tip in place; write M128 before");
    if (guides_tip_ && !machine_.takesTips())
      lines_.fail(
          "with M128 X Y Z are those of the tip, but the machine file has rtcp: false; give the machine file for which the program was "
          "made, or set rtcp: true");
    target.link = lines_.inLink();
    target.feed = feed_;
    target.unit = feedUnit();
    if (!target.rapid && !spindle_ && still_line_ == 0)
      still_line_ = lines_.number();
    if (const Diagnostic fault = track_.move(lines_.number(), target); !fault.empty())
      lines_.fail(fault);
  }

  void takeWord(const ProgramWord& word, ProgramTarget& target, Eigen::Vector3d& axis)
  {
    const std::string& name = word.name;
    if (name == "FMAX") {
      target.rapid = true;
      return;
    }
    if (name == "M")
      return takeM(word);
    if (name == "RL" || name == "RR" || (name == "R" && word.value != 0.0))
      lines_.fail(word, "the control shifts the path by a cutter radius of its table; write the path of the tip, with R0");
    if (!word.value)
      lines_.fail(word, "not a word that is understood; leave it out if it does not move the tool");
    if (name == "F") {
      feed_ = *word.value;
      return;
    }
    for (int i = 0; i < 3; ++i) {
      const std::string letter(1, "XYZ"[i]);
      if (name == letter)
        target.xyz[static_cast<std::size_t>(i)] = *word.value * unit_;
      if (name == "T" + letter)
        axis[i] = *word.value;
      if (name == letter || name == "T" + letter || name == "N" + letter || name == "R")
        return;
    }
    for (std::size_t i = 0; i < 2 && !machine_.three_axes; ++i)
      if (name == std::string(1, machine_.rotary[i].letter)) {
        target.angles[i] = *word.value * degree;
        return;
      }
    lines_.fail(word,
                "not a word that is understood, or not an axis of the machine file; give the machine file for which the program was made");
  }

  ProgramLines lines_;
  const Machine& machine_;
  ProgramTrack track_;
  double next_ = 0.0, unit_ = 1.0, feed_ = 0.0;
  bool guides_tip_ = false, of_machine_ = false, spindle_ = false, ended_ = false;
  std::size_t still_line_ = 0; ///< of the first feed move with the spindle off
};

} // namespace

ProgramFile
readKlartext(const std::string& file, std::string_view text, const Machine& machine)
{
  return KlartextReader(file, text, machine).read();
}

} // namespace pcl_spiral
