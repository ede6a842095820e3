// SPDX-License-Identifier: BSD-3-Clause
#include "part_choice.h"

#include "scan_places.h"
#include "terminal.h"
#include "vocabulary.h"

#include "collision/ball_way.h"
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

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
    throw UsageError(Diagnostic("--crop ", crop, ": give xmin,xmax,ymin,ymax, or these and zmin,zmax, or the file of a polygon"));
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-endless), high = Eigen::Vector3d::Constant(endless);
  for (std::size_t i = 0; i < words.size(); ++i)
    (i % 2 == 0 ? low : high)[static_cast<Eigen::Index>(i / 2)] = numberValue("crop", words[i]);
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] < high[axis]))
      throw UsageError(Diagnostic("--crop ", crop, ": the second number of each pair must be above the first"));
  return {placeInScan(low, read), placeInScan(high, read)};
}

Diagnostic
boxText(const Scan& scan)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& p : *scan.cloud)
    if (pcl::isFinite(p))
      box.extend(p.getVector3fMap().cast<double>());
  return Diagnostic("from ", Place(box.min()), " to ", Place(box.max()));
}

template <typename Cloud>
typename Cloud::Ptr
selected(const Cloud& cloud, const pcl::Indices& indices)
{
  const typename Cloud::Ptr some(new Cloud);
  pcl::copyPointCloud(cloud, indices, *some);
  return some;
}

Surface::ConstPtr
surfaceOf(const std::string& file, const PartSide& side, const Scan& scan, const std::optional<Eigen::Vector3d>& part_at)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan.cloud);
  if (part_at)
    scanned.setPartAt(*part_at);
  scanned.setLargestPart(side.largest_part);
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
    throw FileError(file, scanned.getStatus().diagnostic());
  return surface;
}

/** One normal per point of a scan of \p size points, zero where it is not part of the surface. */
pcl::PointCloud<pcl::Normal>::ConstPtr
normalsOf(const Surface& surface, std::size_t size)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normals->resize(size);
  for (std::size_t i = 0; i < surface.size(); ++i)
    (*normals)[surface.sourceIndex(i)].getNormalVector3fMap() = surface.normal(i).cast<float>();
  return normals;
}

/** A scan that points are taken away from. */
struct CutScan {
  const PartChoice& choice;
  const std::string& file;
  Scan& scan;
  ChosenPart& part; ///< with all keep-outs
};

/** What \p region selects of the scan. */
pcl::Indices
selectedBy(Region& region, const CutScan& from)
{
  region.setInputCloud(from.scan.cloud);
  pcl::Indices kept;
  region.filter(kept);
  if (!region.getStatus().ok())
    throw FileError(from.file, region.getStatus().diagnostic());
  return kept;
}

/** Keeps only \p kept, ascending; adds the points left out that are neither in a keep-out nor among \p echoes, ascending, to those
 *  beside the part. */
void
keepOnly(const pcl::Indices& kept, const pcl::Indices& echoes, CutScan& from)
{
  Scan& scan = from.scan;
  if (kept.empty())
    throw UsageError(Diagnostic(from.file, ": no point is left after --crop", (from.choice.region.empty() ? "" : ", --region"),
                                " and --keep-out; the scan lies ", boxText(scan), ": give a larger crop",
                                (from.choice.region.empty() ? "" : " or region"), ", or smaller keep-outs"));
  auto next = kept.begin();
  for (std::size_t i = 0; i < scan.cloud->size(); ++i) {
    if (next != kept.end() && static_cast<std::size_t>(*next) == i) {
      ++next;
      continue;
    }
    const pcl::PointXYZ& p = (*scan.cloud)[i];
    const auto contains = [&](const Prism& prism) { return prism.contains(p.getVector3fMap().cast<double>()); };
    const std::vector<Prism>& keep_outs = from.part.keep_outs;
    const bool kept_out = std::any_of(keep_outs.begin(), keep_outs.end(), contains);
    if (pcl::isFinite(p) && !std::binary_search(echoes.begin(), echoes.end(), static_cast<pcl::index_t>(i)))
      (kept_out ? from.part.kept_out : from.part.beside).push_back(p.getVector3fMap());
  }
  scan.cloud = selected(*scan.cloud, kept);
  if (scan.normals)
    scan.normals = selected(*scan.normals, kept);
}

/** Points that \p surface left out for \p reason, ascending. */
pcl::Indices
leftOutFor(LeftOut reason, const Surface& surface)
{
  pcl::Indices indices;
  for (std::size_t i = 0; i < surface.leftOut().why.size(); ++i)
    if (surface.leftOut().why[i] == reason)
      indices.push_back(surface.leftOut().indices[i]);
  return indices;
}

pcl::Indices
without(const pcl::Indices& some, const pcl::Indices& all)
{
  pcl::Indices rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

/** Those of the \p isolated points of \p cloud that lie nearer to the points \p others than to \p surface, ascending: points of the table
 *  beside a low part are such. */
pcl::Indices
nearerTo(const pcl::Indices& others, const pcl::Indices& isolated, const Surface& surface, const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  if (others.empty())
    return {};
  std::vector<Eigen::Vector3f> points;
  for (const pcl::index_t i : others)
    points.push_back(cloud[i].getVector3fMap());
  const PointBlocks blocks(std::move(points)), &own = surface.graph().blocks();
  pcl::Indices nearer;
  std::copy_if(isolated.begin(), isolated.end(), std::back_inserter(nearer), [&](pcl::index_t i) {
    const Eigen::Vector3d p = cloud[i].getVector3fMap().cast<double>();
    return (blocks.position(blocks.nearest(p)) - p).norm() < (own.position(own.nearest(p)) - p).norm();
  });
  return nearer;
}

/** Keeps the points at which \p tool stays out of the keep-outs, without the \p strips; adds the others to \p figures. Of several parts
 *  only the one that was chosen is kept: few points left of it between keep-outs would have their neighbours on another one. */
void
keepToolOut(Region& region, const PartTool& tool, const PartSide& side, const StripChoice& strips, CutScan& from, RegionFigures& figures)
{
  const Surface::ConstPtr surface =
      strips.surface && *strips.surface ? *strips.surface : surfaceOf(from.file, side, from.scan, from.part.part_at);
  if (strips.surface)
    *strips.surface = surface;
  region.setInputNormals(normalsOf(*surface, from.scan.cloud->size()));
  region.setToolRadius(tool.radius);
  region.setShank(shank_radii * tool.radius, tool.lean);
  region.setObstacles(from.part.kept_out);
  region.setMargin(surface->spacing() + from.choice.margin); // the outline may lie up to a spacing beyond the last points
  const pcl::Indices others = leftOutFor(LeftOut::OtherPart, *surface), isolated = leftOutFor(LeftOut::Isolated, *surface);
  const pcl::Indices beside = nearerTo(others, isolated, *surface, *from.scan.cloud);
  pcl::Indices kept = without(beside, without(others, selectedBy(region, from)));
  figures.too_close = region.getFigures().too_close;
  if (!surface->keptPart().empty())
    from.scan.warnings.push_back(surface->keptPart());
  const std::vector<UncutStrip> narrow =
      strips.width > 0.0 ? stripsBeside(*surface, *from.scan.cloud, kept, strips.width) : std::vector<UncutStrip>();
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    if (std::find(strips.cut.begin(), strips.cut.end(), i) != strips.cut.end())
      continue;
    kept = without(narrow[i].indices, kept);
    from.part.strips.push_back(narrow[i]);
  }
  const pcl::Indices echoes = without(beside, isolated);
  const auto gone =
      std::count_if(echoes.begin(), echoes.end(), [&kept](pcl::index_t i) { return !std::binary_search(kept.begin(), kept.end(), i); });
  figures.too_close -= static_cast<std::size_t>(gone);
  if (gone > 0)
    from.scan.warnings.push_back(Diagnostic(gone, " single points off the surface near keep-outs were left out: no thing stands there"));
  keepOnly(kept, echoes, from);
}

/** Adds what was left out to the warnings of the scan, which had \p all points. */
void
warnOfCuts(const PartChoice& choice, const RegionFigures& figures, std::size_t all, double tool_radius, Scan& scan)
{
  const bool region = !choice.region.empty();
  if (!choice.crop.empty() || region)
    scan.warnings.push_back(Diagnostic(figures.cropped, " of ", all, " points are outside the ", region ? "region" : "crop",
                                       " and were left out (", region ? "--region" : "--crop", ")"));
  if (!choice.keep_outs.empty())
    scan.warnings.push_back(Diagnostic(
        figures.kept_out, " of ", all, " points are in a keep-out",
        tool_radius > 0.0
            ? Diagnostic(", and ", figures.too_close, " so near to one that the ball would enter it, or the shank what stands there")
            : "",
        ": they are not cut (--keep-out)"));
}

} // namespace

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
           Scan& scan, const StripChoice& strips)
{
  const ReadOptions read = readAsScan(asked);
  ChosenPart part;
  if (choice.part_at)
    part.part_at = placeInScan(*choice.part_at, read);
  if (!choice.cuts())
    return part;
  const std::size_t all = scan.cloud->size();
  Region inside, region;
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
  CutScan from{choice, file, scan, part};
  keepOnly(selectedBy(region, from), {}, from); // first what stands there, which would disturb the normals beside it
  RegionFigures figures = region.getFigures();
  if (!choice.region.empty()) {
    keepOnly(selectedBy(inside, from), {}, from);
    figures.cropped += inside.getFigures().cropped;
  }
  if (!part.keep_outs.empty() && tool.radius > 0.0)
    keepToolOut(region, tool, side, strips, from, figures);
  warnOfCuts(choice, figures, all, tool.radius, scan);
  return part;
}
