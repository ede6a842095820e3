// SPDX-License-Identifier: BSD-3-Clause
#include "part_choice.h"

#include "scan_places.h"
#include "setter_names.h"
#include "terminal.h"

#include "common/formatted_text.h"
#include "verify/ball_way.h"
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <cctype>
#include <cstdio>

using namespace pcl_spiral;

namespace {

using Region = PartRegion<pcl::PointXYZ>;

/** Whether the value of --crop begins with a number, as a box does; a file of that name needs a folder, as ./1.txt. */
bool
isBox(const std::string& crop)
{
  return crop.find(',') != std::string::npos && crop.find_first_not_of("0123456789+-.,eE ") == std::string::npos;
}

/** XMIN,XMAX,YMIN,YMAX or with ZMIN,ZMAX. */
Eigen::AlignedBox3d
boxOf(const std::string& crop, const ReadOptions& read)
{
  constexpr double endless = 1e30;
  const std::vector<std::string> words = listValue(crop);
  if (words.size() != 4 && words.size() != 6)
    throw UsageError("--crop " + crop + ": give xmin,xmax,ymin,ymax, or these and zmin,zmax, or the file of a polygon");
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-endless), high = Eigen::Vector3d::Constant(endless);
  for (std::size_t i = 0; i < words.size(); ++i)
    (i % 2 == 0 ? low : high)[static_cast<Eigen::Index>(i / 2)] = numberValue("crop", words[i]);
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] < high[axis]))
      throw UsageError("--crop " + crop + ": the second number of each pair must be above the first");
  return {placeInScan(low, read), placeInScan(high, read)};
}

std::string
fileBox(const Scan& scan, const ReadOptions& read)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& p : *scan.cloud)
    if (pcl::isFinite(p))
      box.extend(p.getVector3fMap().cast<double>() / millimetres(read.unit) + read.origin);
  return "from " + placeText(box.min()) + " to " + placeText(box.max());
}

template <typename Cloud>
typename Cloud::Ptr
selected(const Cloud& cloud, const pcl::Indices& indices)
{
  const typename Cloud::Ptr some(new Cloud);
  pcl::copyPointCloud(cloud, indices, *some);
  return some;
}

/** One normal per point of the scan, zero where it is not part of the surface; \p spacing of the surface. */
pcl::PointCloud<pcl::Normal>::ConstPtr
surfaceNormals(const std::string& file, const PartSide& side, const Scan& scan, double& spacing)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan.cloud);
  ScanSide own = side.side;
  own.normals = own.normals ? scan.normals : nullptr;
  setSide(own, scanned);
  scanned.setFlipNormals(side.flip_normals);
  scanned.setNumberOfThreads(side.threads);
  scanned.setStrict(false); // the part itself is checked later
  scanned.setQuiet(true);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    throw FileError(file, inOptions(scanned.getStatus().message()));
  spacing = surface->spacing();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normals->resize(scan.cloud->size());
  for (std::size_t i = 0; i < surface->size(); ++i)
    (*normals)[surface->sourceIndex(i)].getNormalVector3fMap() = surface->normal(i).cast<float>();
  return normals;
}

/** A scan that points are taken away from. */
struct CutScan {
  const PartChoice& choice;
  const std::string& file;
  const ReadOptions& read;
  Scan& scan;
  ChosenPart& part; ///< with all keep-outs
};

/** Keeps what \p region selects; adds the points left out that are not in a keep-out to those beside the part. */
void
cut(Region& region, CutScan& from)
{
  Scan& scan = from.scan;
  region.setInputCloud(scan.cloud);
  pcl::Indices kept;
  region.filter(kept);
  if (!region.getStatus().ok())
    throw FileError(from.file, inOptions(region.getStatus().message()));
  if (kept.empty())
    throw UsageError(from.file + ": no point is left after --crop" + (from.choice.region.empty() ? "" : ", --region") +
                     " and --keep-out; the scan lies " + fileBox(scan, from.read) + ": give a larger crop" +
                     (from.choice.region.empty() ? "" : " or region") + ", or smaller keep-outs");
  for (const auto i : *region.getRemovedIndices()) {
    const pcl::PointXYZ& p = (*scan.cloud)[static_cast<std::size_t>(i)];
    const auto contains = [&](const Prism& prism) { return prism.contains(p.getVector3fMap().cast<double>()); };
    const std::vector<Prism>& keep_outs = from.part.keep_outs;
    const bool kept_out = std::any_of(keep_outs.begin(), keep_outs.end(), contains);
    if (pcl::isFinite(p))
      (kept_out ? from.part.kept_out : from.part.beside).push_back(p.getVector3fMap());
  }
  scan.cloud = selected(*scan.cloud, kept);
  if (scan.normals)
    scan.normals = selected(*scan.normals, kept);
}

/** Adds what was left out to the warnings of the scan, which had \p all points. */
void
warnOfCuts(const PartChoice& choice, const RegionFigures& figures, std::size_t all, double tool_radius, Scan& scan)
{
  const bool region = !choice.region.empty();
  if (!choice.crop.empty() || region)
    scan.warnings.push_back(textOf(figures.cropped, " of ", all, " points are outside the ", region ? "region" : "crop",
                                   " and were left out (", region ? "--region" : "--crop", ")"));
  if (!choice.keep_outs.empty())
    scan.warnings.push_back(
        textOf(figures.kept_out, " of ", all, " points are in a keep-out",
               tool_radius > 0.0
                   ? textOf(", and ", figures.too_close, " so near to one that the ball would enter it, or the shank what stands there")
                   : "",
               ": they are not cut (--keep-out)"));
}

} // namespace

std::vector<Option>
placeOptions(PartChoice& choice)
{
  return {placeOption("part-at",
                      "a place on the part, in the coordinates of the file: of several separate parts use the nearest one: "
                      "--part-at 120,80,15",
                      choice.part_at),
          textOption("crop", "BOX|FILE",
                     "only points inside are part of the scan: xmin,xmax,ymin,ymax or also ,zmin,zmax, or the file of a polygon, in the "
                     "coordinates of the file of the scan: --crop 0,200,0,150",
                     choice.crop),
          {"keep-out", "FILE",
           "the cutter does not enter the space over and under this polygon; may be given several times; one corner per line: x y, "
           "extended along z, or x y z, extended along its mean normal: --keep-out clamp.txt",
           [&choice](const std::string& value) { choice.keep_outs.push_back(value); }, true}};
}

Option
clustersOption(PartChoice& choice)
{
  return choiceOption("clusters",
                      "two or more points near each other that stand off the surface, as a screw or spatter, are refused, ridden over "
                      "without cutting into them, or left out as false echoes, and the path goes through them; default refuse: "
                      "--clusters ride",
                      choice.clusters);
}

std::vector<InputName>
polygonFiles(const PartChoice& choice)
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

ChosenPart
choosePart(const PartChoice& choice, const std::string& file, const ReadOptions& asked, const PartTool& tool, const PartSide& side,
           Scan& scan)
{
  const ReadOptions read = readAsScan(asked);
  ChosenPart part;
  if (choice.part_at)
    part.part_at = placeInScan(*choice.part_at, read);
  if (!choice.cuts())
    return part;
  const std::size_t all = scan.cloud->size();
  Region inside(true), region(true);
  if (!choice.region.empty())
    inside.setCrop(readPolygon(choice.region, read));
  if (isBox(choice.crop))
    region.setCropBox(boxOf(choice.crop, read));
  else if (!choice.crop.empty())
    region.setCrop(readPolygon(choice.crop, read));
  for (const std::string& keep_out : choice.keep_outs) {
    part.keep_outs.push_back(readPolygon(keep_out, read));
    region.addKeepOut(part.keep_outs.back());
  }
  CutScan from{choice, file, read, scan, part};
  cut(region, from); // first what stands there, which would disturb the normals beside it
  RegionFigures figures = region.getFigures();
  if (!choice.region.empty()) {
    cut(inside, from);
    figures.cropped += inside.getFigures().cropped;
  }
  if (!part.keep_outs.empty() && tool.radius > 0.0) {
    double spacing = 0.0;
    region.setInputNormals(surfaceNormals(file, side, scan, spacing));
    region.setToolRadius(tool.radius);
    region.setShank(shank_radii * tool.radius, tool.lean);
    region.setObstacles(part.kept_out);
    region.setMargin(spacing); // the outline may lie up to a spacing beyond the last points
    cut(region, from);
    figures.too_close = region.getFigures().too_close;
  }
  warnOfCuts(choice, figures, all, tool.radius, scan);
  return part;
}

std::string
withFilePlaces(const std::string& message, const ReadOptions& asked)
{
  const ReadOptions read = readAsScan(asked);
  if (read.unit == LengthUnit::Millimetre && read.origin.isZero())
    return message;
  const std::string before = "mm2 at (";
  std::string text = message;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    Eigen::Vector3d p;
    if (std::sscanf(text.c_str() + at, "%lf, %lf, %lf", &p.x(), &p.y(), &p.z()) != 3)
      continue;
    p = p / millimetres(read.unit) + read.origin;
    text.insert(text.find(')', at) + 1, formatted(" (in the file %.10g,%.10g,%.10g)", p.x(), p.y(), p.z()));
  }
  return text;
}
