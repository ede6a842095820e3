// SPDX-License-Identifier: BSD-3-Clause
#include "control_program.h"
#include "gcode_words.h"
#include "known_lines.h"
#include "program_track.h"

#include "io/kinematics_text.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <array>

namespace pcl_spiral {
namespace {

/** Words of a line that carry places and values, by name. */
class GCodeReader {
public:
  GCodeReader(const std::string& file, std::string_view text, const Machine& machine, Dialect dialect)
  : lines_(file, text), machine_(machine), dialect_(dialect), track_(machine, dialect == Dialect::LinuxCNC)
  {
    modes_.guides_tip = dialect == Dialect::LinuxCNC && machine.takesTips();
    names_ = dialect == Dialect::Siemens ? std::array<const char*, 3>{"A3", "B3", "C3"} : std::array<const char*, 3>{"I", "J", "K"};
  }

  ProgramFile read()
  {
    while (!modes_.ended && lines_.next())
      takeLine();
    if (!modes_.ended)
      lines_.fail("the program ends without M2 or M30: it was cut off, or it is a subprogram; write it again");
    if (!track_.begun())
      lines_.fail("the program has no place with all five axes; name them all in one G0");
    ProgramFile result = track_.take();
    result.still_line = still_line_;
    result.tolerance = tolerance_;
    result.axis_arcs = dialect_ == Dialect::Siemens; // ORIVECT
    return result;
  }

private:
  void takeLine()
  {
    const ControlWords& words = machine_.words;
    const std::string_view line = lineWithoutNumber(lines_.text());
    if (isShopLine(machine_, line))
      return;
    if (machine_.takesTips() && (line == words.tip_control_on || line == words.tip_control_off)) {
      modes_.guides_tip = line == words.tip_control_on;
      return;
    }
    modes_.of_machine = modes_.dwells = modes_.takes_values = false;
    for (const ProgramWord& word : lines_.words())
      if (const std::string fault = takeCode(word); !fault.empty())
        lines_.fail(word, Diagnostic(fault));
    requireOffset();
    takeTolerance();
    ProgramTarget target;
    std::array<std::optional<double>, 3> vector;
    for (const ProgramWord& word : lines_.words())
      takeValue(word, target, vector);
    if (vector[0] || vector[1] || vector[2])
      takeVector(vector, target);
    if (target.names())
      move(target);
  }

  /** Modes and codes. \return why it is refused */
  std::string takeCode(const ProgramWord& word)
  {
    if (word.name == "G" && word.value)
      return takeG(dialect_, *word.value, modes_);
    if (word.name == "M" && word.value)
      return takeM(dialect_, *word.value, track_.begun(), modes_);
    if (word.name == "CYCLE" && word.value == 832.0 && dialect_ == Dialect::Siemens)
      return {}; // smoothing
    if (!word.value)
      return takeKeyword(dialect_, word.name, modes_);
    if (word.name == "D" && dialect_ == Dialect::Siemens)
      modes_.tool_length = *word.value > 0.0;
    return {};
  }

  /** The tolerance at corners of LinuxCNC: G64 P; none with G64 alone; G61 and G61.1 stop. */
  void takeTolerance()
  {
    constexpr double none = 1000.0; // mm: more than any corner takes
    if (dialect_ != Dialect::LinuxCNC)
      return;
    bool smooths = false;
    for (const ProgramWord& word : lines_.words())
      if (word.name == "G" && word.value && *word.value >= 61.0 && *word.value <= 64.0) {
        smooths = *word.value == 64.0;
        tolerance_ = smooths ? none : 0.0;
      }
    for (const ProgramWord& word : lines_.words())
      if (smooths && word.name == "P" && word.value)
        tolerance_ = *word.value * modes_.unit;
  }

  /** Refuses a work offset other than that of the program's own comment. */
  void requireOffset() const
  {
    for (const std::string& comment : lines_.comments()) {
      const std::string_view text = trimmed(comment);
      const std::string_view opening = offset_opening;
      if (text.substr(0, opening.size()) != opening || modes_.offset.empty())
        continue;
      const std::string_view made_for = text.substr(opening.size());
      if (made_for.substr(0, made_for.find(' ')) != modes_.offset)
        lines_.fail(Diagnostic(modes_.offset, ": the comment says that the program was made for the work offset ", std::string(made_for),
                               "; write that one, or correct the comment if the part is set up there"));
    }
  }

  void takeValue(const ProgramWord& word, ProgramTarget& target, std::array<std::optional<double>, 3>& vector)
  {
    const std::string& name = word.name;
    if (name == "G" || name == "M" || name == "CYCLE" || !word.value)
      return;
    if (name == "F") {
      feed_ = *word.value;
      feed_unit_ = modes_.unit;
      fed_ = lines_.number();
      return;
    }
    constexpr std::array<const char*, 5> settings{"N", "S", "T", "H", "D"}, values{"P", "Q", "E", "X", "U"};
    if (isOneOf(name, settings) || (name == "O" && (dialect_ == Dialect::Fanuc || dialect_ == Dialect::FanucVectors)) ||
        (modes_.dwells && isOneOf(name, values)))
      return;
    if (modes_.takes_values && (name == "P" || name == "Q" || name == "E"))
      return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (name == std::string(1, "XYZ"[i]))
        return set(word, target.xyz[i], modes_.unit);
      if (name == names_[i] && modes_.vectors)
        return set(word, vector[i], 1.0);
    }
    for (std::size_t i = 0; i < 2 && !machine_.three_axes; ++i)
      if (name == std::string(1, machine_.rotary[i].letter))
        return set(word, target.angles[i], degree);
    lines_.fail(word, reasonOf(name));
  }

  template <std::size_t Count>
  static bool isOneOf(const std::string& name, const std::array<const char*, Count>& names)
  {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  Diagnostic reasonOf(const std::string& name) const
  {
    if (machine_.three_axes && (name == "A" || name == "B" || name == "C"))
      return "the machine file has three axes; give the machine file for which the program was made";
    const std::string axes = std::string(1, machine_.rotary[0].letter) + " and " + machine_.rotary[1].letter;
    if (name == "A" || name == "B" || name == "C")
      return Diagnostic("the rotary axes of the machine file are ", axes, "; give the machine file for which the program was made");
    if (name == "O" || name == "L")
      return "a subprogram or a loop; write all moves in one program";
    if (name == "I" || name == "J" || name == "K")
      return Diagnostic("the centre of an arc, or a tool axis outside G43.5; write straight moves with ", axes);
    return "not a word that is understood here; leave it out if it does not move the tool";
  }

  void set(const ProgramWord& word, std::optional<double>& place, double unit)
  {
    if (place)
      lines_.fail(word, "the axis is named twice in this line; leave one out");
    place = *word.value * unit;
  }

  void takeVector(const std::array<std::optional<double>, 3>& vector, ProgramTarget& target)
  {
    const std::string all = std::string(names_[0]) + " " + names_[1] + " " + names_[2];
    if (!vector[0] || !vector[1] || !vector[2])
      lines_.fail(Diagnostic("the tool axis needs ", all, ", and one is missing; name all three"));
    const Eigen::Vector3d axis(*vector[0], *vector[1], *vector[2]);
    if (!(axis.norm() > 1e-6))
      lines_.fail(Diagnostic("the tool axis ", all, " has no length; name its direction"));
    target.axis = axis.normalized();
  }

  /** Refuses X Y Z that are not those of the machine file: before the control knows the tool, or with another meaning. A rapid along X and
   *  Y alone is the way over the first point. */
  void requireGuided(const ProgramTarget& target) const
  {
    if (target.of_machine || !(target.xyz[0] || target.xyz[1] || target.xyz[2] || !target.rapid) || (target.rapid && !target.xyz[2]))
      return;
    if (!modes_.tool_length)
      lines_.fail(dialect_ == Dialect::Siemens
                      ? "the tool length is not on, and the control would move the spindle's end to X Y Z; write D1 before"
                      : "the tool length is not on, and the control would move the spindle's end to X Y Z; write G43 before");
    if (modes_.guides_tip == machine_.takesTips())
      return;
    lines_.fail(machine_.takesTips()
                    ? "X Y Z are those of the machine, without G43.4, G43.5, TRAORI or M428, but the machine file has rtcp: true; give the "
                      "machine file for which the program was made, or set rtcp: false"
                    : "X Y Z are those of the tip, but the machine file has rtcp: false; give the machine file for which the program "
                      "was made, or set rtcp: true");
  }

  void move(ProgramTarget& target)
  {
    target.of_machine = modes_.of_machine;
    if (!modes_.rapid)
      lines_.fail("axes are named, but neither G0 nor G1 is on; write one of them");
    target.rapid = *modes_.rapid;
    target.link = lines_.inLink();
    target.of_tip = modes_.guides_tip && machine_.takesTips();
    requireGuided(target);
    target.inverse_time = modes_.inverse_time;
    target.feed = modes_.inverse_time && fed_ != lines_.number() ? 0.0 : feed_;
    target.unit = feed_unit_;
    target.counts_degrees = (dialect_ == Dialect::Fanuc || dialect_ == Dialect::FanucVectors) && !modes_.guides_tip;
    if (!target.rapid && !modes_.spindle && still_line_ == 0)
      still_line_ = lines_.number();
    if (const Diagnostic fault = track_.move(lines_.number(), target); !fault.empty())
      lines_.fail(fault);
  }

  ProgramLines lines_;
  const Machine& machine_;
  Dialect dialect_;
  ProgramTrack track_;
  GCodeModes modes_;
  std::array<const char*, 3> names_; ///< words of the tool axis
  double feed_ = 0.0, feed_unit_ = 1.0;
  std::size_t fed_ = 0;        ///< line of the last F
  std::size_t still_line_ = 0; ///< of the first feed move with the spindle off
  std::optional<double> tolerance_;
};

} // namespace

ProgramFile
readGCode(const std::string& file, std::string_view text, const Machine& machine, Dialect dialect)
{
  return GCodeReader(file, text, machine, dialect).read();
}

} // namespace pcl_spiral
