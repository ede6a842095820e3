// SPDX-License-Identifier: BSD-3-Clause
#include "plan_program.h"

#include "io/byte_file.h"
#include "io/cutter_text.h"
#include "io/setting_names.h"

#include <algorithm>
#include <filesystem>
#include <regex>

namespace pcl_spiral {

ProgramTexts
programTexts(const SpiralSettings& s, const std::string& title)
{
  return {title,
          {"cutter " + cutterText(CutterShape::ball(s.tool_radius)),
           Diagnostic("scallop height ", s.scallop_height, " mm, chord error ", s.chord_error, " mm, feed ", s.feed, " mm/min").text()},
          s.chord_error};
}

ProgramTexts
programTexts(const PassSettings& settings, double feed, const std::string& title)
{
  ProgramTexts texts{title, {}, settings.tolerance};
  if (settings.cutter.radius > 0.0)
    texts.notes.push_back("cutter " + cutterText(settings.cutter));
  texts.notes.push_back(Diagnostic("tolerance ", settings.tolerance, " mm, feed ", feed, " mm/min").text());
  return texts;
}

ProgramHeader
headerOf(ProgramHeader asked, const ProgramTexts& texts, const std::string& machine_file, const std::optional<double>& smoothing)
{
  asked.title = texts.title;
  asked.notes = texts.notes;
  if (!machine_file.empty())
    asked.notes.push_back("machine file " + std::filesystem::path(machine_file).filename().string());
  asked.smoothing = smoothing.value_or(texts.chord_error);
  return asked;
}

Diagnostic
missingFor(const std::string& output, bool has_machine, bool has_dialect, int tool)
{
  const std::string extension = lowerExtension(output);
  if (extension != ".ngc" && !has_machine)
    return "no {setMachine} is given; give the machine file, such as {setMachine} xyzac.yaml (there are examples in examples/machines, "
           "installed in share/pcl_spiral)";
  if (extension == ".nc" && !has_dialect)
    return Diagnostic("no {Dialect} is given; it must be one of ", choiceList<Dialect>());
  if (extension != ".ngc" && tool == 0)
    return "no {ProgramHeader::tool} is given; the control needs the tool number for the tool length: {ProgramHeader::tool} 3";
  return {};
}

std::optional<IdleSetting>
idleOfProgram(const AskedNames& asked, const std::vector<std::string>& outputs, Dialect dialect)
{
  bool any_program = false, any_frames = false, any_cldata = false, any_in_language = false;
  for (const std::string& output : outputs) {
    const std::string extension = lowerExtension(output);
    const bool is_program = isProgramExtension(extension);
    any_program = any_program || is_program;
    any_frames = any_frames || extension == ".yaml";
    any_cldata = any_cldata || extension == ".apt" || extension == ".cls";
    any_in_language = any_in_language || (is_program && dialectOfExtension(extension).value_or(dialect) == dialect);
  }
  IdleRules rules(asked);
  rules.require(any_in_language, {"dialect"},
                Diagnostic(": no output is in the language ", choiceName(dialect),
                           "; write a .nc (a .ngc is always for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain), or leave it out"));
  rules.require(any_frames, {"robot_z"}, ": no output has robot frames; add an output .yaml, or leave it out");
  rules.require(any_program, {"stay_down"},
                ": no output is a program, and only programs have links; add an output .ngc, .nc, .mpf or .h, or leave it out");
  rules.require(any_program, {"gains"}, ": no output is a program, whose time could be less; write one such as part.ngc, or leave it out");
  rules.require(any_program, {"feed_mode", "work_offset", "smoothing", "line_numbers", "decimals"},
                ": no output is a program; write one such as part.ngc, or leave it out");
  rules.require(any_program || any_cldata, {"coolant", "spindle", "spindle_direction", "tool"},
                ": no output is a program or CLDATA; write one such as part.ngc or part.apt, or leave it out");
  return rules.found();
}

Diagnostic
noMachineWarning()
{
  return "no {setMachine} is given: the program is for LinuxCNC's xyzac-trt-kins with all offsets zero and both rotary axes at up to 30 "
         "rev/min; no limits are checked";
}

Diagnostics
spindleWarnings(const std::string& output, const Machine& machine, const ProgramHeader& header)
{
  const std::regex starts("\\{spindle\\}|(^|[^A-Za-z])M0?[34]($|[^0-9])");
  const auto& lines = machine.lines.header;
  if (header.spindle_speed > 0.0 ||
      std::any_of(lines.begin(), lines.end(), [&starts](const std::string& line) { return std::regex_search(line, starts); }))
    return {};
  return {Diagnostic(output, ": the spindle stands still: no {ProgramHeader::spindle_speed} is given, and no line of the machine file "
                             "starts it; give {ProgramHeader::spindle_speed} 12000, or start it in program: {{header: [...]}} of the "
                             "machine file")};
}

} // namespace pcl_spiral
