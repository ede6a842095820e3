// SPDX-License-Identifier: BSD-3-Clause
#include "parts.h"

#include "planning/pass_defaults.h"

namespace pcl_spiral::python {
namespace {

/** \p given as an array of one row; nothing for a file or another shape. */
py::array
rowOf(const py::object& given)
{
  py::array numbers = fileOf(given) ? py::array() : py::array::ensure(given);
  if (!numbers)
    PyErr_Clear();
  return numbers && numbers.ndim() == 1 ? numbers : py::array();
}

} // namespace

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
                             "ArrayLike | str | PathLike[str] | None",
                             "only points inside are of the part: (xmin, xmax, ymin, ymax) or also zmin, zmax; corners of a polygon, or "
                             "its file",
                             {"setCropBox", "setCrop"}},
                            {"keep_outs",
                             "Sequence[ArrayLike | str | PathLike[str]]",
                             "polygons that the cutter does not enter: corners (N, 2), along z, or (N, 3), or files",
                             {"addKeepOut"}},
                            {"regions",
                             "Sequence[ArrayLike | str | PathLike[str]]",
                             "parts with a path of their own: polygons, or places (x, y, z) on separate parts",
                             {"addRegion", "PartRegion"}}};
}

std::vector<Setting>
cutterTable(const NumberRange& radius, CutterShape& cutter, double& corner_radius)
{
  const NumberRange length = NumberRange::from(0.0);
  return {Setting("tool_radius", "setCutter", "tool radius", "radius of the cutter at the upper end of its flank", "6", cutter.radius)
              .in("mm", radius),
          Setting("corner_radius", "CutterShape::corner_radius", "corner radius", "of the end of the cutter; a ball if it is not given",
                  "1", corner_radius)
              .in("mm", length),
          Setting("flank_length", "setFlankLength", "flank length", "of the cutting flank along its slant, above the corner", "20",
                  cutter.flank_length)
              .in("mm", length),
          Setting("flank_angle", "CutterShape::flank_angle", "flank angle", "between flank and axis", "5", cutter.flank_angle)
              .in("degrees", length.below(90.0))};
}

void
completeCutter(const Keywords& keywords, double corner_radius, const Words& words, CutterShape& cutter)
{
  cutter.corner_radius = corner_radius;
  if (!keywords.isGiven("corner_radius"))
    setLargestCorner(cutter);
  if (const Diagnostic fault = faultOf(cutter); cutter.radius > 0.0 && !fault.empty())
    raise("invalid-argument", Diagnostic("tool_radius=, corner_radius=, flank_length= and flank_angle=: ", fault), words);
}

std::optional<Eigen::AlignedBox3d>
boxOf(const py::object& given, const ReadOptions& read, const Words& words)
{
  const py::array numbers = rowOf(given);
  if (!numbers || (numbers.size() != 4 && numbers.size() != 6))
    return std::nullopt;
  constexpr double endless = 1e30;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-endless), high = Eigen::Vector3d::Constant(endless);
  for (py::ssize_t i = 0; i < numbers.size(); ++i)
    (i % 2 == 0 ? low : high)[i / 2] = numberFrom("crop", numbers[py::int_(i)]);
  if (!(low.array() < high.array()).all())
    raise("invalid-argument", "crop=: the second number of each pair must be above the first", words);
  const double scale = millimetres(read.unit);
  return Eigen::AlignedBox3d(scale * (low - read.origin), scale * (high - read.origin));
}

PlanRegion
regionOf(const py::object& given, const ReadOptions& read, const Eigen::Vector3d& shift, const Words& words)
{
  if (const py::array numbers = rowOf(given); numbers && numbers.size() == 3)
    return {std::nullopt, placeFrom("regions", given) - shift, ""};
  return {polygonOf("regions", given, read, words), std::nullopt, ""};
}

} // namespace pcl_spiral::python
