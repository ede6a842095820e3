// SPDX-License-Identifier: BSD-3-Clause
#include "planning/part_selection.h"

#include "planning/uncut_strips.h"

#include "collision/ball_way.h"
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <iterator>

namespace pcl_spiral {
namespace {

using Region = PartRegion<pcl::PointXYZ>;

Diagnostic
boxText(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  Eigen::AlignedBox3d box;
  for (const pcl::PointXYZ& p : cloud)
    if (pcl::isFinite(p))
      box.extend(p.getVector3fMap().cast<double>());
  return Diagnostic("from ", Place(box.min()), " to ", Place(box.max()));
}

/** What leaves no point of \p cloud, and what to do. */
Diagnostic
noneLeftText(const PartChoice& choice, const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  Diagnostic given, remedy;
  const auto add = [&](bool is_given, const char* setter, const char* change) {
    if (!is_given)
      return;
    given += Diagnostic(given.empty() ? "" : " and ", setter);
    remedy += Diagnostic(remedy.empty() ? "" : " or ", change);
  };
  add(choice.crop_box.has_value(), "{setCropBox}", "a larger crop");
  add(choice.crop.has_value(), "{setCrop}", "a larger crop");
  add(choice.region.has_value(), "{addRegion}", "a larger region");
  add(!choice.keep_outs.empty(), "{addKeepOut}", "smaller keep-outs");
  return Diagnostic("no point is left after ", given, "; the {scan} lies ", boxText(cloud), ": give ", remedy);
}

template <typename Cloud>
typename Cloud::Ptr
selected(const Cloud& cloud, const pcl::Indices& indices)
{
  const typename Cloud::Ptr some(new Cloud);
  pcl::copyPointCloud(cloud, indices, *some);
  return some;
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

/** Takes points away from a scan, step by step. */
class Selection {
public:
  Selection(const WholeScan& scan, const PartChoice& choice, ChosenPart& part)
  : settings_(scan.settings), choice_(choice), cloud_(scan.cloud), normals_(scan.normals), part_(part)
  {}

  /** Keeps what \p region selects. */
  Status keep(Region& region)
  {
    pcl::Indices kept;
    const Status status = select(region, kept);
    return status.ok() ? keepOnly(kept, {}) : status;
  }

  /** Keeps only \p kept, ascending; adds the points left out that are neither in a keep-out nor among \p echoes, ascending, to those
   *  beside the part. */
  Status keepOnly(const pcl::Indices& kept, const pcl::Indices& echoes)
  {
    if (kept.empty())
      return {StatusCode::InvalidArgument, noneLeftText(choice_, *cloud_)};
    auto next = kept.begin();
    for (std::size_t i = 0; i < cloud_->size(); ++i) {
      if (next != kept.end() && static_cast<std::size_t>(*next) == i) {
        ++next;
        continue;
      }
      const pcl::PointXYZ& p = (*cloud_)[i];
      const auto contains = [&](const Prism& prism) { return prism.contains(p.getVector3fMap().cast<double>()); };
      const bool kept_out = std::any_of(choice_.keep_outs.begin(), choice_.keep_outs.end(), contains);
      if (pcl::isFinite(p) && !std::binary_search(echoes.begin(), echoes.end(), static_cast<pcl::index_t>(i)))
        (kept_out ? part_.kept_out : part_.beside).push_back(p.getVector3fMap());
    }
    part_.cloud = selected(*cloud_, kept);
    cloud_ = part_.cloud;
    if (normals_) {
      part_.normals = selected(*normals_, kept);
      normals_ = part_.normals;
    }
    return Status::success();
  }

  /** Keeps the points at which \p tool stays out of the keep-outs of \p region, without the \p strips; adds the others to \p figures. Of
   *  several parts only the one that was chosen is kept: few points left of it between keep-outs would have their neighbours on another
   *  one. */
  Status keepToolOut(Region& region, const PartTool& tool, const StripChoice& strips, RegionReport& figures)
  {
    Surface::ConstPtr surface;
    if (strips.surface && *strips.surface)
      surface = *strips.surface;
    else if (const Status status = makeSurface(surface); !surface)
      return {status.code() == StatusCode::Cancelled ? StatusCode::Cancelled : StatusCode::InvalidInput, status.diagnostic()};
    if (strips.surface)
      *strips.surface = surface;
    region.setInputNormals(normalsOf(*surface, cloud_->size()));
    region.setToolRadius(tool.radius);
    region.setShank(shank_radii * tool.radius, tool.lean);
    region.setObstacles(part_.kept_out);
    region.setMargin(surface->spacing() + choice_.margin); // the outline may lie up to a spacing beyond the last points
    pcl::Indices kept;
    if (const Status status = select(region, kept); !status.ok())
      return status;
    if (kept.empty())
      return {StatusCode::InvalidInput, Diagnostic("no point is left at which a ball of ", tool.radius,
                                                   " {mm} stays out of the keep-outs ({addKeepOut}): give smaller "
                                                   "ones, or take a smaller ball ({setToolRadius})")};
    const pcl::Indices others = leftOutFor(LeftOut::OtherPart, *surface), isolated = leftOutFor(LeftOut::Isolated, *surface);
    const pcl::Indices beside = nearerTo(others, isolated, *surface, *cloud_);
    kept = without(beside, without(others, kept));
    figures.too_close = region.getReport().too_close;
    if (!surface->keptPart().empty())
      part_.warnings.push_back(surface->keptPart());
    leaveOut(strips, *surface, kept);
    const pcl::Indices echoes = without(beside, isolated);
    const auto gone =
        std::count_if(echoes.begin(), echoes.end(), [&kept](pcl::index_t i) { return !std::binary_search(kept.begin(), kept.end(), i); });
    figures.too_close -= static_cast<std::size_t>(gone);
    if (gone > 0)
      part_.warnings.push_back(Diagnostic(gone, " single points off the surface near keep-outs were left out: no thing stands there"));
    return keepOnly(kept, echoes);
  }

private:
  /** What \p region selects. */
  Status select(Region& region, pcl::Indices& kept)
  {
    region.setInputCloud(cloud_);
    region.setQuiet(true);
    region.filter(kept);
    return region.getStatus();
  }

  /** The surface of the points left; null if there is none. */
  Status makeSurface(Surface::ConstPtr& surface) const
  {
    SurfaceSettings settings;
    settings.trust_normals = settings_.trust_normals;
    settings.view_point = settings_.view_point;
    settings.heights = settings_.heights;
    settings.flip_normals = settings_.flip_normals;
    settings.part_at = choice_.part_at;
    settings.largest_part = settings_.largest_part;
    settings.threads = settings_.threads;
    ScannedSurface<pcl::PointXYZ> scanned;
    scanned.setInputCloud(cloud_);
    scanned.setInputNormals(normals_);
    scanned.setSettings(settings);
    scanned.setStrict(false); // the part itself is checked later
    scanned.setQuiet(true);
    scanned.compute(surface);
    return scanned.getStatus();
  }

  /** Takes the narrow strips beside keep-outs away from \p kept. */
  void leaveOut(const StripChoice& strips, const Surface& surface, pcl::Indices& kept)
  {
    if (strips.width <= 0.0)
      return;
    const std::vector<UncutStrip> narrow = stripsBeside(surface, *cloud_, kept, strips.width);
    for (std::size_t i = 0; i < narrow.size(); ++i) {
      if (std::find(strips.cut.begin(), strips.cut.end(), i) != strips.cut.end())
        continue;
      kept = without(narrow[i].indices, kept);
      part_.strips.push_back(narrow[i]);
    }
  }

  const SurfaceSettings& settings_;
  const PartChoice& choice_;
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud_; ///< what is left
  pcl::PointCloud<pcl::Normal>::ConstPtr normals_; ///< of it
  ChosenPart& part_;
};

/** Says what was left out of a scan that had \p all points. */
void
warnOfCuts(const PartChoice& choice, const RegionReport& figures, std::size_t all, double tool_radius, Diagnostics& warnings)
{
  if (choice.crop_box || choice.crop || choice.region)
    warnings.push_back(Diagnostic(figures.cropped, " of ", all, " points are outside the ", choice.region ? "region" : "crop",
                                  " and were left out (",
                                  choice.region     ? "{addRegion}"
                                  : choice.crop_box ? "{setCropBox}"
                                                    : "{setCrop}",
                                  ")"));
  if (!choice.keep_outs.empty())
    warnings.push_back(Diagnostic(
        figures.kept_out, " of ", all, " points are in a keep-out",
        tool_radius > 0.0
            ? Diagnostic(", and ", figures.too_close, " so near to one that the ball would enter it, or the shank what stands there")
            : "",
        ": they are not cut ({addKeepOut})"));
}

} // namespace

Status
choosePart(const WholeScan& scan, const PartChoice& choice, const PartTool& tool, const StripChoice& strips, ChosenPart& part)
{
  part = ChosenPart();
  part.part_at = choice.part_at;
  part.keep_outs = choice.keep_outs;
  Selection selection(scan, choice, part);
  if (scan.indices) {
    pcl::Indices ascending = *scan.indices;
    std::sort(ascending.begin(), ascending.end());
    ascending.erase(std::unique(ascending.begin(), ascending.end()), ascending.end());
    if (ascending.empty())
      return {StatusCode::InvalidArgument, "the indices are empty ({setIndices}): give the points of the part"};
    if (const Status status = selection.keepOnly(ascending, {}); !status.ok())
      return status;
  }
  if (!choice.cuts())
    return Status::success();
  Region inside, region;
  if (choice.region)
    inside.setCrop(*choice.region);
  if (choice.crop_box)
    region.setCropBox(*choice.crop_box);
  if (choice.crop)
    region.setCrop(*choice.crop);
  for (const Prism& keep_out : choice.keep_outs)
    region.addKeepOut(keep_out);
  if (const Status status = selection.keep(region); !status.ok()) // first what stands there, which would disturb the normals beside it
    return status;
  RegionReport figures = region.getReport();
  if (choice.region) {
    if (const Status status = selection.keep(inside); !status.ok())
      return status;
    figures.cropped += inside.getReport().cropped;
  }
  if (!choice.keep_outs.empty() && tool.radius > 0.0)
    if (const Status status = selection.keepToolOut(region, tool, strips, figures); !status.ok())
      return status;
  warnOfCuts(choice, figures, scan.cloud->size(), tool.radius, part.warnings);
  return Status::success();
}

} // namespace pcl_spiral
