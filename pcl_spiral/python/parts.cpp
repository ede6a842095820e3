// SPDX-License-Identifier: BSD-3-Clause
#include "parts.h"

#include "core/given_together.h"
#include "planning/pass_defaults.h"

namespace pcl_spiral::python {
namespace {

/** The polygons of \p list as Python has them: rows of corners, or names of files. */
std::string
polygonsText(const py::list& list)
{
  py::list shown;
  for (const py::handle one : list)
    shown.append(py::hasattr(one, "tolist") ? one.attr("tolist")() : py::reinterpret_borrow<py::object>(one));
  return py::str(py::repr(shown));
}

} // namespace

const std::vector<Input> holder_input{
    {"holder",
     "Sequence[Sequence[float]]",
     "shank and holder above the flank, upwards: (radius, length) or (lower radius, upper radius, length)",
     {"setHolder", "PassSettings::holder"}}};
const std::vector<Input> progress_input{{"progress",
                                         "Progress | None",
                                         "called with the share done and the name of the stage; return False to cancel, or raise",
                                         {"setProgressCallback"}}};

std::vector<Input>
operator+(std::vector<Input> inputs, const std::vector<Input>& more)
{
  inputs.insert(inputs.end(), more.begin(), more.end());
  return inputs;
}

std::vector<Input>
partInputs()
{
  return scanInputs() +
         std::vector<Input>{{"crop",
                             "ArrayLike | File | None",
                             "only points inside are of the part: (xmin, xmax, ymin, ymax) or also zmin, zmax; corners of a polygon, or "
                             "its file",
                             {"setCropBox", "setCrop"}},
                            {"keep_outs",
                             "Sequence[ArrayLike | File] | ArrayLike | File",
                             "polygons that the cutter does not enter: corners (N, 2), along z, or (N, 3), or files",
                             {"addKeepOut"}},
                            {"regions",
                             "Sequence[ArrayLike | File] | ArrayLike | File",
                             "parts with a path of their own: polygons, or places (x, y, z) on separate parts",
                             {"addRegion", "PartRegion"}}};
}

void
completeCutter(const Keywords& keywords, const Words& words, CutterShape& cutter)
{
  if (!keywords.isGiven("corner_radius"))
    setLargestCorner(cutter);
  if (const Diagnostic fault = faultOf(cutter); cutter.radius > 0.0 && !fault.empty())
    raise("invalid-argument", Diagnostic("tool_radius=, corner_radius=, flank_length= and flank_angle=: ", fault), words,
          {"tool_radius", "corner_radius", "flank_length", "flank_angle"});
}

void
requireUsed(const std::optional<IdleSetting>& idle, const Words& words)
{
  if (idle)
    raise("invalid-argument", Diagnostic(idle->name, "=", idle->remedy), words, {idle->name});
}

void
Call::begin(Keywords& keywords, const py::dict& given, const py::object& points, SurfaceSettings& surface, const std::string& normals)
{
  keywords.take(given);
  Vocabulary vocabulary = keywords.vocabulary();
  words = {vocabulary, units.options()};
  if (!points.is_none())
    scan = scanOf(points, keywords, units, words, normals);
  if (scan.mesh)
    vocabulary.words.insert({{"scan", "mesh"}, {"cloud", "mesh"}, {"scanned surface", "surface"}, {"on the scan", "on the mesh"}});
  if (const py::list keep_outs = keywords.list("keep_outs"); !keep_outs.empty()) // more of them do not replace these
    vocabulary.words.emplace(beforeValues("addKeepOut"), "keep_outs=" + polygonsText(keep_outs) + " + ");
  words = {vocabulary, units.options(scan.shift)};
  keywords.readPlaces(words.read);
  scan.asked_view_point = surface.view_point;
  surface.view_point = std::nullopt;
  scan.trust_given = scan.name.empty() || keywords.isGiven("trust_normals");
}

RunFiles
Call::files(const Diagnostics& warnings) const
{
  RunFiles files{scan.name, units.unit, units.origin.value_or(Eigen::Vector3d::Zero()), {}, warnings};
  files.shift = scan.shift;
  files.words = words.vocabulary;
  files.words.place = nullptr; // the writer moves places
  return files;
}

Eigen::AlignedBox3d
boxOf(const py::array_t<double>& numbers, const Words& words)
{
  constexpr double endless = 1e30;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-endless), high = Eigen::Vector3d::Constant(endless);
  for (py::ssize_t i = 0; i < numbers.size(); ++i)
    (i % 2 == 0 ? low : high)[i / 2] = numbers.at(i);
  if (!(low.array() < high.array()).all())
    raise("invalid-argument", "crop=: the second number of each pair must be above the first", words, {"crop"});
  const ReadOptions& read = words.read;
  return Eigen::AlignedBox3d(millimetres(read.unit) * (low - read.origin), millimetres(read.unit) * (high - read.origin));
}

} // namespace pcl_spiral::python
