// SPDX-License-Identifier: BSD-3-Clause
// Programs of machines, CLDATA and robot frames of a path.
#include "parts.h"
#include "path.h"

#include "io/byte_file.h"
#include "io/post/plan_program.h"
#include "io/post/post_check.h"
#include "io/setting_names.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/planning/program_planner.h>

#include <pybind11/stl.h>

namespace pcl_spiral::python {
namespace {

struct ProgramCall {
  ProgramSettings settings;
  ProgramHeader header;
  std::optional<double> smoothing;
  std::optional<Dialect> dialect;
  RobotZ robot_z = RobotZ::Axis;
  Keywords keywords{
      "program",
      settingTable(settings) + settingTable(header) +
          std::vector<Setting>{Setting("dialect", "Dialect", "language",
                                       "of a .nc; a .ngc is for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain", "siemens", dialect),
                               Setting("smoothing", "ProgramHeader::smoothing", "smoothing",
                                       "tolerance of the control's own smoothing; 0: exact stop", "0.01", smoothing)
                                   .in("mm", NumberRange::from(0.0))
                                   .zeroFor("the chord error"),
                               Setting("robot_z", "RobotZ", "z of robot frames",
                                       "along the tool axis at the tip, or along the normal at the contact", "normal", robot_z)},
      std::vector<Input>{{"machine", "File | None", "machine file in YAML: axes, limits, rates", {"setMachine"}},
                         {"work_offset", "str", "work offset in the words of the control, such as G55", {"ProgramHeader::work_offset"}},
                         {"pass_begin", "str", "a line before each pass, such as M62 P0", {"ProgramHeader::pass_begin"}},
                         {"pass_end", "str", "a line after each pass, such as M63 P0", {"ProgramHeader::pass_end"}},
                         {"block_tolerance",
                          "tuple[float, float] | None",
                          "largest distance of machine moves from the path: mm of the tip, degrees of the axis",
                          {}},
                         {"thin_blocks", "tuple[float, float] | None", "leave out blocks that change the path by less: mm, degrees", {}}} +
          progress_input};

  BlockTolerance tolerance(const char* name, const BlockTolerance& default_value) const
  {
    const py::object given = keywords[name];
    return given.is_none() ? default_value : BlockTolerance{given[py::int_(0)].cast<double>(), degree * given[py::int_(1)].cast<double>()};
  }
  std::string text(const char* name) const { return keywords.isGiven(name) ? keywords[name].cast<std::string>() : std::string(); }
};

/** The planner for \p path, and what the program says of it. */
ProgramTexts
setPlan(const Path& path, ProgramPlanner& planner)
{
  const PathSource& source = *path.source;
  if (source.spiral) {
    planner.setInputPlan(*source.spiral);
    return programTexts(source.spiral->settings, source.title);
  }
  planner.setInputPlan(*source.passes);
  return programTexts(source.tool, path.motion.feed, source.title);
}

/** Machine and header of a program \p file, checked. */
Machine
machineOf(const ProgramCall& call, const std::string& file, const std::string& machine_file, Dialect language, const Words& words)
{
  if (const Diagnostic missing = missingFor(file, !machine_file.empty(), call.dialect.has_value(), call.header.tool); !missing.empty())
    raise("invalid-argument", Diagnostic(file, ": ", missing), words);
  const Machine machine = machine_file.empty() ? xyzacTrunnion() : withFiles(words, [&] { return readMachine(machine_file); });
  if (const Diagnostic fault = faultOfSettings(language, machine, call.header); !fault.empty())
    raise("invalid-argument", Diagnostic(file, ": ", fault), words);
  return machine;
}

template <typename Write>
void
writeOne(const std::string& file, const Words& words, Write write)
{
  withFiles(words, [&] {
    OutputFiles files({file});
    write(files.temporary(0));
    files.commit();
  });
}

py::dict
writeMoves(const Path& path, const std::string& file, const ProgramCall& call, const Words& words)
{
  const auto planner = std::make_shared<ProgramPlanner>();
  const ProgramTexts texts = setPlan(path, *planner);
  planner->setSettings(call.settings);
  const auto moves = std::make_shared<std::vector<ToolMoves>>();
  compute(planner, Run(call.keywords["progress"]), words, moves);
  const PathSource& source = *path.source;
  writeOne(file, words, [&](const std::string& temporary) {
    if (lowerExtension(file) == ".yaml")
      return writeRobotFrames(temporary, *moves, call.robot_z);
    const AptCutter cutter = source.spiral ? ballCutter(path.motion.tool_radius) : aptCutter(CutterProfile(source.tool.cutter));
    writeAPT(temporary, *moves,
             {texts.title, cutter, call.header.spindle_speed, call.header.spindle_direction, call.header.coolant, call.header.tool});
  });
  return py::dict(py::arg("file") = file, py::arg("warnings") = textsOf(planner->getWarnings(), words.vocabulary));
}

py::dict
writeBlocks(const Path& path, const std::string& file, const ProgramCall& call, const Words& words)
{
  const std::string machine_file = call.text("machine");
  const Dialect language = dialectOfExtension(lowerExtension(file)).value_or(call.dialect.value_or(Dialect::LinuxCNC));
  const Machine machine = machineOf(call, file, machine_file, language, words);
  const auto planner = std::make_shared<ProgramPlanner>();
  const ProgramTexts texts = setPlan(path, *planner);
  planner->setMachine(machine);
  planner->setSettings(call.settings);
  const auto program = std::make_shared<MachineProgram>();
  compute(planner, Run(call.keywords["progress"]), words, program);
  Diagnostics warnings = spindleWarnings(file, machine, call.header);
  if (machine_file.empty())
    warnings.push_back(noMachineWarning());
  warnings.insert(warnings.end(), planner->getWarnings().begin(), planner->getWarnings().end());
  writeOne(file, words, [&](const std::string& temporary) {
    pcl_spiral::writeProgram(temporary, *program, language, headerOf(call.header, texts, machine_file, call.smoothing));
  });
  return py::dict(py::arg("file") = file, py::arg("blocks") = program->blocks.size(), py::arg("minutes") = program->report.minutes,
                  py::arg("warnings") = textsOf(warnings, words.vocabulary));
}

} // namespace

py::dict
writeProgram(const Path& path, const std::string& file, const py::dict& given)
{
  ProgramCall call;
  call.keywords.take(given);
  const Words words{call.keywords.vocabulary(), path.source ? path.source->read : ReadOptions()};
  call.settings.feed = path.motion.feed;
  call.settings.block = call.tolerance("block_tolerance", call.settings.block);
  call.settings.thinning = call.tolerance("thin_blocks", call.settings.thinning);
  call.header.work_offset = call.text("work_offset");
  call.header.pass_begin = call.text("pass_begin");
  call.header.pass_end = call.text("pass_end");
  const std::string extension = lowerExtension(file);
  const bool has_moves = extension == ".yaml" || extension == ".apt" || extension == ".cls";
  if (!has_moves && !isProgramExtension(extension))
    raise("invalid-argument",
          Diagnostic(file, ": the extension '", extension, "' is not known; use .ngc .nc .mpf .h .apt .cls or .yaml, and save() for paths"),
          words);
  const AskedNames asked = call.keywords.asked();
  if (has_moves && asked.count("machine") > 0)
    raise("invalid-argument", Diagnostic(file, ": machine= belongs to programs; leave it out, or write one such as part.ngc"), words,
          {"machine"});
  requireUsed(idleOfProgram(asked, {file}, call.dialect.value_or(Dialect::LinuxCNC)), words);
  if (!path.source)
    raise("invalid-argument",
          "this path has no scan, by which the leads of a program are checked, for it was unpickled or made of stages: make it by "
          "spiral(), drive() or ridge(), and its program at once",
          words);
  if (extension != ".yaml" && has_moves && path.source->passes && !(path.source->tool.cutter.radius > 0.0))
    raise("invalid-argument", Diagnostic(file, ": this format needs a cutter, and the tool is a beam; use .yaml or a program"), words);
  return has_moves ? writeMoves(path, file, call, words) : writeBlocks(path, file, call, words);
}

void
addPrograms(py::dict& tables)
{
  ProgramCall().keywords.addTo(tables);
}

} // namespace pcl_spiral::python
