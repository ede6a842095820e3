// SPDX-License-Identifier: BSD-3-Clause
#include "part_options.h"

#include "scan_places.h"

#include "planning/proposed_value.h"
#include <pcl_spiral/io/polygon_reader.h>

using namespace pcl_spiral;

namespace {

/** Whether \p value has numbers alone, as a box does; a file of that name needs a folder, as ./1.txt. */
bool
isBox(const std::string& value)
{
  return value.find(',') != std::string::npos && value.find_first_not_of("0123456789+-.,eE ") == std::string::npos;
}

/** XMIN,XMAX,YMIN,YMAX or, where \p heights are taken, with ZMIN,ZMAX. */
Eigen::AlignedBox3d
boxOf(const std::string& option, const std::string& value, bool heights, const ReadOptions& read)
{
  constexpr double endless = 1e30;
  const std::vector<std::string> words = listValue(value);
  if (words.size() != 4 && !(heights && words.size() == 6))
    throw UsageError(Diagnostic("--", option, " ", value, ": give xmin,xmax,ymin,ymax, ", heights ? "or these and zmin,zmax, " : "",
                                "or the file of a polygon"));
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-endless), high = Eigen::Vector3d::Constant(endless);
  for (std::size_t i = 0; i < words.size(); ++i)
    (i % 2 == 0 ? low : high)[static_cast<Eigen::Index>(i / 2)] = numberValue(option, words[i]);
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] < high[axis]))
      throw UsageError(Diagnostic("--", option, " ", value, ": the second number of each pair must be above the first"));
  return {placeInScan(low, read), placeInScan(high, read)};
}

} // namespace

std::vector<Option>
placeOptions(PartOptions& choice)
{
  return {placeOption("part-at",
                      "a place on the part, in the coordinates of the file: of several separate parts use the nearest one: "
                      "--part-at 120,80,15",
                      choice.part_at),
          textOption("crop", "BOX|FILE",
                     "only points inside are part of the scan: xmin,xmax,ymin,ymax or also ,zmin,zmax, or the file of a polygon, in the "
                     "coordinates of the file of the scan: --crop 0,200,0,150",
                     choice.crop),
          {"keep-out", "BOX|FILE",
           "the cutter does not enter the space over and under this polygon, or xmin,xmax,ymin,ymax; may be given several times; one "
           "corner per line: x y, extended along z, or x y z, extended along its mean normal: --keep-out clamp.txt",
           [&choice](const std::string& value) { choice.keep_outs.push_back(value); }, true}};
}

Option
clustersOption(PartOptions& choice)
{
  return choiceOption("clusters",
                      "two or more points near each other that stand off the surface, as a screw or spatter, are refused, ridden over "
                      "without cutting into them, or left out as false echoes, and the path goes through them; default refuse: "
                      "--clusters ride",
                      choice.clusters);
}

std::vector<InputName>
polygonFiles(const PartOptions& choice)
{
  std::vector<InputName> files{{"the crop", choice.crop}};
  for (const std::string& file : choice.keep_outs)
    files.push_back({"a keep-out", file});
  return files;
}

Eigen::Vector3d
placeInScan(const Eigen::Vector3d& place, const ReadOptions& read)
{
  return millimetres(read.unit) * (place - read.origin);
}

Eigen::Vector3d
placeInFile(const Eigen::Vector3d& place, const ReadOptions& asked)
{
  const ReadOptions read = readAsScan(asked);
  return place / millimetres(read.unit) + read.origin;
}

PartChoice
choiceOf(const PartOptions& options, const ReadOptions& asked)
{
  const ReadOptions read = readAsScan(asked);
  PartChoice choice;
  choice.clusters = options.clusters;
  if (options.part_at)
    choice.part_at = placeInScan(*options.part_at, read);
  if (!options.region.empty())
    choice.region = readPolygon(options.region, read);
  if (isBox(options.crop))
    choice.crop_box = boxOf("crop", options.crop, true, read);
  else if (!options.crop.empty())
    choice.crop = readPolygon(options.crop, read);
  for (const std::string& keep_out : options.keep_outs)
    choice.keep_outs.push_back(isBox(keep_out) ? uprightPrism(boxOf("keep-out", keep_out, false, read)) : readPolygon(keep_out, read));
  return choice;
}
