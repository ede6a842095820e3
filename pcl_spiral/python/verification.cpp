// SPDX-License-Identifier: BSD-3-Clause
// verify(): a path or a program, judged by the scan.
#include "parts.h"
#include "path.h"
#include "running.h"

#include "io/byte_file.h"
#include "io/report/moved_places.h"
#include "io/setting_names.h"
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/verification_writer.h>
#include <pcl_spiral/planning/path_verifier.h>

#include <pybind11/stl.h>

#include <algorithm>

namespace pcl_spiral::python {
namespace {

/** A verifier whose settings of the surface can be set at once. */
struct OpenVerifier : PathVerifier<pcl::PointXYZ> {
  using PathVerifier<pcl::PointXYZ>::surfaceSettings;
};

struct VerifyCall {
  GivenUnits units;
  JudgeSettings judge;
  SurfaceSettings surface;
  MeshSettings mesh;
  Limits limits;
  double corner_radius = 0.0;
  std::optional<Dialect> dialect;
  Words words;
  GivenScan scan;

  VerifyCall() { surface.clusters = ClusterHandling::Ride; }

  Keywords keywords{"verify",
                    cutterTable(NumberRange::above(0.0), judge.cutter, corner_radius) + settingTable(judge) + settingTable(limits) +
                        settingTable(mesh) + without(settingTable(surface), {"neighbours", "alpha"}) + units.table() +
                        std::vector<Setting>{Setting("dialect", "Dialect", "language",
                                                     "of a program .nc; found from its words if it is not given", "siemens", dialect)},
                    partInputs() +
                        std::vector<Input>{{"machine", "str | PathLike[str] | None", "machine file of a program", {"setMachine"}}} +
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
  if (isProgramExtension(extension) || extension == ".apt" || extension == ".cls") {
    const std::optional<std::string> machine = fileOf(call.keywords["machine"]);
    if (!machine && isProgramExtension(extension))
      raise("invalid-argument", Diagnostic(file, ": a program has the axes of a machine; give its file ({setMachine})"), call.words);
    verifier.setInputProgram(readProgram(file, machine ? std::optional(readMachine(*machine)) : std::nullopt, call.dialect));
    return;
  }
  ToolpathFile read = readToolpath(file, call.scan.shift);
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(read.path)));
  verifier.setInputTips(read.tips);
  verifier.setHasContacts(read.has_contacts);
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
    const Heights& heights = verifier.getHeights(k);
    deviation.append(py::array_t<float>(static_cast<py::ssize_t>(heights.deviation.size()), heights.deviation.data()));
    stock.append(py::array_t<float>(static_cast<py::ssize_t>(heights.stock.size()), heights.stock.data()));
  }
  VerificationRun run;
  run.scan = call.scan.name;
  run.unit = call.units.unit;
  run.cutter = call.judge.cutter;
  run.scallop_height = call.judge.scallop_height;
  run.chord_error = call.judge.chord_error;
  run.warnings = call.scan.warnings;
  run.limits = call.limits;
  run.shift = call.scan.shift;
  run.words = vocabulary;
  run.words.place = nullptr; // the writer moves places
  return py::dict(py::arg("report_text") = verificationsJSON(run, found), py::arg("broken") = py::tuple(py::cast(broken)),
                  py::arg("warnings") = py::tuple(py::cast(warnings)), py::arg("deviation") = py::tuple(deviation),
                  py::arg("stock") = py::tuple(stock));
}

void
setPart(VerifyCall& call, OpenVerifier& verifier)
{
  const bool on_mesh = call.scan.mesh != nullptr;
  if (on_mesh) {
    call.surface.flip_normals = false; // the mesh is turned
    verifier.setInputMesh(call.scan.mesh);
  }
  else
    verifier.setInputCloud(call.scan.cloud);
  verifier.setMeshSettings(call.mesh);
  call.scan.asked_view_point = call.surface.view_point;
  for (std::optional<Eigen::Vector3d>* place : {&call.scan.asked_view_point, &call.surface.part_at})
    if (*place)
      **place -= call.scan.shift;
  call.surface.view_point = std::nullopt;
  call.surface.strict = verifier.surfaceSettings().strict;
  verifier.surfaceSettings() = call.surface;
  if (!on_mesh || call.scan.normals || call.scan.asked_view_point)
    call.scan.setSide(verifier, call.scan.name.empty() || call.keywords.isGiven("trust_normals"));
  setPart(call.keywords, call.units.options(call.scan.shift), call.scan.shift, call.words, verifier);
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
  call.keywords.take(given);
  call.words.vocabulary = call.keywords.vocabulary();
  call.scan = scanOf(points, call.keywords, call.units, call.words);
  call.words.shift = call.scan.shift;
  call.words.vocabulary = movedBy(call.scan.shift, call.words.vocabulary);
  completeCutter(call.keywords, call.corner_radius, call.words, call.judge.cutter);
  const auto verifier = std::make_shared<OpenVerifier>();
  setPart(call, *verifier);
  const std::optional<std::string> file = fileOf(judged);
  if (!file && !py::isinstance<Path>(judged))
    raiseType("verify() takes a Path, or the file of a path or of a program, as its second argument");
  if (file)
    withFiles(call.words, [&] { giveFile(*file, call, *verifier); });
  else
    givePath(judged.cast<const Path&>(), call, *verifier);
  const Run run(call.keywords["progress"]);
  const auto found = std::make_shared<std::vector<Verification>>();
  verifier->setQuiet(true);
  verifier->setProgressCallback(run.progress());
  run([verifier, found] { verifier->compute(*found); });
  require(verifier->getStatus(), call.words);
  return resultOf(call, *verifier, *found, file.value_or(""));
}

} // namespace

py::list
verifyKeywords()
{
  return VerifyCall().keywords.table();
}

void
addVerification(py::module_& module)
{
  module.def("verify", &verify);
}

} // namespace pcl_spiral::python
