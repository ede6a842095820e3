// SPDX-License-Identifier: BSD-3-Clause
#include "scan_places.h"

#include "common/formatted_text.h"
#include "io/report/moved_places.h"
#include <pcl_spiral/core/diagnostic.h>

using namespace pcl_spiral;

const char* const origin_help =
    "point to subtract from the coordinates, in their unit; the outputs are then relative to it. Default: map coordinates are shifted "
    "to a round place near the part, and shifted back in .csv .ply .vtp; 0,0,0 for no shift: --origin 393775,3689071,0";
const char* const units_help =
    "unit of the numbers in the files: ft is the international foot, us-ft the US survey foot of 1200/3937 m; default mm: --units m";
const char* const view_point_help = "position of the scanner, in the scan's coordinates, mm; normals point to it: --view-point 0,0,3000";

namespace {

Eigen::Vector3d run_shift = Eigen::Vector3d::Zero(); ///< of the one scan of this process
ReadOptions run_read;                                ///< how it was read, without the shift

/** Whether messages have each place also as the file has it. */
bool
hasFilePlaces()
{
  return run_read.unit != LengthUnit::Millimetre || !run_read.origin.isZero();
}

/** A place of the scan as the file has it, to 0.001 mm, as placeText shows it. */
Eigen::Vector3d
inFile(const Eigen::Vector3d& place)
{
  const Eigen::Vector3d shown = (1e3 * place).array().round() / 1e3;
  return shown / millimetres(run_read.unit) + run_read.origin;
}

/** " (in the file 1,2,3)" for a place of the scan, if the file has other coordinates. */
std::string
filePlace(const Eigen::Vector3d& place)
{
  if (!hasFilePlaces())
    return "";
  const Eigen::Vector3d p = inFile(place);
  return formatted(" (in the file %.10g,%.10g,%.10g)", p.x(), p.y(), p.z());
}

} // namespace

ReadOptions
readFindingOrigin()
{
  ReadOptions read;
  read.find_origin = true;
  return read;
}

void
setOrigin(const std::string& value, ReadOptions& read)
{
  read.origin = placeValue("origin", value);
  read.find_origin = false;
}

Option
originOption(ReadOptions& read)
{
  return {"origin", "X,Y,Z", origin_help, [&read](const std::string& value) { setOrigin(value, read); }};
}

void
setScanFrame(const Eigen::Vector3d& shift, const ReadOptions& asked)
{
  run_shift = shift;
  run_read = asked;
}

const Eigen::Vector3d&
scanShift()
{
  return run_shift;
}

ReadOptions
readAsScan(ReadOptions read)
{
  read.origin += run_shift / millimetres(read.unit);
  read.find_origin = false;
  return read;
}

Eigen::Vector3d
fromScan(const Eigen::Vector3d& place)
{
  return place - run_shift;
}

std::optional<Eigen::Vector3d>
fromScan(const std::optional<Eigen::Vector3d>& place)
{
  return place ? std::optional(fromScan(*place)) : std::nullopt;
}

Eigen::Vector3d
inScan(const Eigen::Vector3d& place)
{
  return place + run_shift;
}

std::string
shownPlace(const Eigen::Vector3d& place)
{
  return placeText(inScan(place)) + filePlace(inScan(place));
}

std::string
optionValue(const Proposed::Value& value)
{
  if (const auto* place = std::get_if<Eigen::Vector3d>(&value)) {
    const Eigen::Vector3d p = inFile(inScan(*place));
    return formatted("%.12g,%.12g,%.12g", p.x(), p.y(), p.z());
  }
  if (const auto* box = std::get_if<Extents>(&value)) {
    const Eigen::Vector3d low = inFile(inScan(box->low)), high = inFile(inScan(box->high));
    return formatted("%.12g,%.12g,%.12g,%.12g", low.x(), high.x(), low.y(), high.y());
  }
  const auto* word = std::get_if<std::string>(&value);
  return word ? *word : Diagnostic(std::get<double>(value)).text();
}

SpiralReport
inScan(SpiralReport report)
{
  return movedBy(run_shift, std::move(report));
}

Verification
inScan(Verification verification)
{
  return movedBy(run_shift, std::move(verification));
}

std::string
shiftText()
{
  return formatted("%.0f, %.0f, %.0f mm", run_shift.x(), run_shift.y(), run_shift.z());
}

std::string
titleWithShift(const std::string& title)
{
  return run_shift.isZero() ? title : title + ", coordinates less " + shiftText();
}

std::string
shiftLine()
{
  if (run_shift.isZero())
    return "";
  return "shift           map coordinates less " + shiftText() +
         ": added again in .csv .ply .vtp, reports and messages; pictures, .pcd and files for machines are relative to that place\n";
}
