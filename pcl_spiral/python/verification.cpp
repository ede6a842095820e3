// SPDX-License-Identifier: BSD-3-Clause
// verify(): a path or a program, judged by the scan.
#include "parts.h"
#include "path.h"

#include "io/byte_file.h"
#include "io/setting_names.h"
#include "planning/input_tables.h"
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/verification_writer.h>
#include <pcl_spiral/planning/path_verifier.h>

#include <pybind11/stl.h>

namespace pcl_spiral::python {
namespace {

using OpenVerifier = OpenPlanner<PathVerifier<pcl::PointXYZ>>;

struct VerifyCall : Call {
  JudgeSettings judge;
  SurfaceSettings surface = OpenVerifier().getSurface();
  MeshSettings mesh;
  Limits limits;
  std::optional<Dialect> dialect;
  Keywords keywords{"verify",
                    cutterTable(judge.cutter, NumberRange::above(0.0)) + settingTable(judge) + settingTable(limits) + settingTable(mesh) +
                        only(settingTable(surface), {"neighbours", "alpha"}, false) + units.table() +
                        std::vector<Setting>{Setting("dialect", "Dialect", "language",
                                                     "of a program .nc; found from its words if it is not given", "siemens", dialect)},
                    partInputs() + std::vector<Input>{{"machine", "File | None", "machine file of a program", {"setMachine"}}} +
                        progress_input};
};

/** A path of Python in the coordinates of the scan that it is judged by. */
void
givePath(const Path& path, const VerifyCall& call, OpenVerifier& verifier)
{
  const Eigen::Vector3d off = path.motion.origin - call.scan.shift;
  if (off.isZero(0.0))
    verifier.setInputToolpath(path.points);
  else {
    const auto moved = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(*path.points);
    for (ToolpathPoint& point : *moved)
      point.getVector3fMap() = (point.getVector3fMap().cast<double>() + off).cast<float>();
    verifier.setInputToolpath(moved);
  }
  Polyline tips = path.motion.tips;
  for (Eigen::Vector3d& tip : tips)
    tip += off;
  verifier.setInputTips(tips);
}

void
giveFile(const std::string& file, const VerifyCall& call, OpenVerifier& verifier)
{
  const std::string extension = lowerExtension(file);
  const bool is_blocks = isProgramExtension(extension), is_program = is_blocks || extension == ".apt" || extension == ".cls";
  const py::object machine = call.keywords["machine"];
  if (machine.is_none() && is_blocks)
    raise("invalid-argument", Diagnostic(file, ": a program has the axes of a machine; give its file ({setMachine})"), call.words);
  const std::string machine_file = machine.is_none() ? "" : machine.cast<std::string>();
  withFiles(call.words, [&] {
    if (is_program)
      return verifier.setInputProgram(
          readProgram(file, machine_file.empty() ? std::nullopt : std::optional(readMachine(machine_file)), call.dialect));
    ToolpathFile read = readToolpath(file, call.scan.shift);
    verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(read.path)));
    verifier.setInputTips(read.tips);
    verifier.setHasContacts(read.has_contacts);
  });
}

/** machine= and dialect= belong to programs, and a language may be known by the extension. */
void
requireMeant(const std::string& file, const VerifyCall& call)
{
  requireUsed(idleOfJudging(call.keywords.asked(), call.asked(call.keywords)), call.words);
  const std::string extension = lowerExtension(file);
  const bool is_program = isProgramExtension(extension) || extension == ".apt" || extension == ".cls";
  const std::optional<Dialect> own = dialectOfExtension(extension);
  IdleRules rules(call.keywords.asked());
  rules.require(is_program, {"machine", "dialect"}, ": belongs to programs; give a .ngc, .nc, .mpf, .h or .apt, or leave it out");
  rules.require(!own || own == call.dialect, {"dialect"},
                Diagnostic(": the language of ", file, " is known by its extension; leave it out"));
  requireUsed(rules.found(), call.words);
}

py::dict
resultOf(const VerifyCall& call, OpenVerifier& verifier, std::vector<Verification>& found, const std::string& name)
{
  const Vocabulary& vocabulary = call.words.vocabulary;
  std::vector<std::string> broken, warnings = textsOf(call.scan.warnings, vocabulary);
  py::list deviation, stock;
  for (std::size_t k = 0; k < found.size(); ++k) {
    found[k].path = name;
    for (const std::string& text : textsOf(found[k].broken, vocabulary))
      broken.push_back(text);
    for (const std::string& text : textsOf(warningsOf(found[k]), vocabulary))
      warnings.push_back(text);
    deviation.append(numbersOf(verifier.getHeights(k).deviation));
    stock.append(numbersOf(verifier.getHeights(k).stock));
  }
  const RunFiles files = call.files(call.scan.warnings);
  VerificationRun run{
      files.scan,   files.unit,  call.judge.cutter, call.judge.scallop_height, call.judge.chord_error, files.warnings, call.limits,
      std::nullopt, files.shift, files.words};
  return py::dict(py::arg("_report_text") = verificationsJSON(run, found), py::arg("broken") = py::tuple(py::cast(broken)),
                  py::arg("warnings") = py::tuple(py::cast(warnings)), py::arg("deviation") = py::tuple(deviation),
                  py::arg("stock") = py::tuple(stock));
}

void
setJudge(VerifyCall& call, OpenVerifier& verifier)
{
  call.surface.flip_normals = call.surface.flip_normals && !call.scan.mesh; // the mesh is turned
  verifier.setSurface(call.surface);
  setPart(call, call.keywords, verifier);
  verifier.setMeshSettings(call.mesh);
  verifier.setCutter(call.judge.cutter);
  verifier.setScallopHeight(call.judge.scallop_height);
  verifier.setChordError(call.judge.chord_error);
  verifier.setSampleSpacing(call.judge.sample_spacing);
  verifier.setLimits(call.limits);
}

py::dict
verify(const py::object& points, const py::object& judged, const py::dict& given)
{
  VerifyCall call;
  const bool is_file = py::isinstance<py::str>(judged);
  const std::string file = is_file ? judged.cast<std::string>() : "";
  call.begin(call.keywords, given, points, call.surface);
  requireMeant(file, call);
  completeCutter(call.keywords, call.words, call.judge.cutter);
  const auto verifier = std::make_shared<OpenVerifier>();
  setJudge(call, *verifier);
  if (is_file)
    giveFile(file, call, *verifier);
  else
    givePath(judged.cast<const Path&>(), call, *verifier);
  const auto found = std::make_shared<std::vector<Verification>>();
  compute(verifier, Run(call.keywords["progress"]), call.words, found);
  return resultOf(call, *verifier, *found, file);
}

} // namespace

void
addVerification(py::module_& module, py::dict& tables)
{
  module.def("verify", &verify);
  VerifyCall().keywords.addTo(tables);
}

} // namespace pcl_spiral::python
