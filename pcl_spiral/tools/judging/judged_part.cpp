// SPDX-License-Identifier: BSD-3-Clause
#include "judged_part.h"

#include "terminal/scan_places.h"

#include "collision/ball_way.h"
#include "planning/plan_regions.h"
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace pcl_spiral;

namespace {

constexpr double most_lean = 60.0;    // degrees
constexpr double single_points = 5.0; // times their noise: no point is farther from the surface

JudgedPart
meshPart(const std::string& file, const ReadOptions& read, const MeshChoice& mesh)
{
  JudgedPart part;
  const MeshFile faces = readMesh(file, read);
  setScanFrame(faces.shift, read);
  part.warnings = faces.warnings;
  if (const Status status = SurfaceMesh::make(*faces.mesh, mesh.settings, part.mesh); !status.ok())
    throw FileError(file, status.diagnostic());
  return part;
}

/** One region of the scan; \p scan was read with \p warnings. */
JudgedPart
regionOf(const std::string& file, const ReadOptions& read, const NamedRegion& region, const std::optional<Eigen::Vector3d>& view_point,
         const JudgedRegion& asked, Scan scan)
{
  JudgedPart part;
  part.region = region.name;
  part.whole = scan.cloud;
  scan.warnings.clear();
  part.side = sideOf(scan, view_point);
  part.chosen = choosePart(region.part, file, read, asked.tool, part.side, asked.flip_normals, asked.threads, scan);
  part.side = sideOf(scan, view_point);
  part.cloud = scan.cloud;
  part.warnings = ofRegion(region.name, scan.warnings);
  return part;
}

/** The middles of balls about the whole cutter between corner and flank, as pcl_spiral_drive keeps it out. */
std::vector<std::vector<Eigen::Vector3d>>
keptOutWays(const pcl::PointCloud<ToolpathPoint>& path, const CutterShape& cutter, const Polyline& tips)
{
  if (isBall(cutter) || tips.empty())
    return {ballCentres(path, cutter.radius)};
  std::vector<std::vector<Eigen::Vector3d>> ways(2);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d axis = path[i].getAxisVector3fMap().cast<double>();
    ways[0].push_back(tips[i] + cutter.corner_radius * axis);
    ways[1].push_back(ways[0].back() + cutter.flank_length * axis);
  }
  return ways;
}

/** The deepest of the points \p beside the part; \p words: what cuts into it. */
std::optional<BallEntry>
cutBeside(const std::vector<Eigen::Vector3f>& beside, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings,
          Diagnostic& words)
{
  const CutterShape& cutter = settings.cutter;
  if (isBall(cutter)) {
    words = Diagnostic("the ball or its shank, taken as ", shank_radii, " radii long,");
    return deepestPoint(*path, cutter.radius, beside);
  }
  words = "the cutter";
  CutterPath moves;
  std::unique_ptr<CutterSweep> sweep;
  if (beside.empty() || !readCutterPath(path, moves).ok() || !makeSweep(moves, cutter, settings.tips, sweep).ok())
    return std::nullopt;
  std::vector<double> depths(beside.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(beside.size()); ++i)
    depths[i] = sweep->deepest(beside[i].cast<double>());
  return deepestOf(beside, depths);
}

} // namespace

std::vector<JudgedPart>
readParts(const std::string& file, const ReadOptions& read, const std::optional<MeshChoice>& mesh, const ScanSide& side,
          const JudgedRegion& asked)
{
  if (mesh)
    return {meshPart(file, read, *mesh)};
  const Scan scan = readCloud(file, read);
  setScanFrame(scan.shift, read);
  const std::optional<Eigen::Vector3d> view_point = fromScan(side.view_point);
  std::vector<JudgedPart> parts;
  for (const NamedRegion& region : regionsOf(asked.choice, asked.regions, read))
    parts.push_back(inRegion(region.name, [&] { return regionOf(file, read, region, view_point, asked, scan); }));
  Diagnostics& warnings = parts.front().warnings;
  const Diagnostics& reading = scan.warnings;
  warnings.insert(warnings.begin(), reading.begin(), reading.end());
  return parts;
}

double
leanOf(const pcl::PointCloud<ToolpathPoint>& path)
{
  constexpr double share = 0.01; // of the points may lean more
  std::vector<double> cosines;
  for (const ToolpathPoint& p : path)
    cosines.push_back(p.getNormalVector3fMap().cast<double>().dot(p.getAxisVector3fMap().cast<double>()));
  if (cosines.empty())
    return 0.0;
  const auto least = cosines.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(cosines.size()));
  std::nth_element(cosines.begin(), least, cosines.end());
  return std::min(most_lean, std::acos(std::clamp(*least, -1.0, 1.0)) / degree);
}

Diagnostics
faultsBeside(const JudgedPart& part, const Surface& reference, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
             const JudgeSettings& settings, double allowed, Diagnostics& warnings)
{
  Diagnostics faults;
  const char* cutter = isBall(settings.cutter) ? "ball" : "cutter";
  std::optional<BallEntry> entry;
  if (!part.chosen.keep_outs.empty())
    for (const auto& way : keptOutWays(*path, settings.cutter, settings.tips))
      if (const auto found = deepestEntry(*path, way, settings.cutter.radius, part.chosen.keep_outs);
          found && (!entry || found->depth > entry->depth))
        entry = found;
  if (entry)
    faults.push_back(Diagnostic("the ", cutter, " enters a keep-out by ", entry->depth, " mm at ", Place(entry->place)));
  std::vector<Eigen::Vector3f> others;
  for (std::size_t i = 0; !part.mesh && i < reference.leftOut().why.size(); ++i)
    if (reference.leftOut().why[i] == LeftOut::OtherPart)
      others.push_back(reference.leftOut().positions[i]);
  const auto cutInto = [&](const std::vector<Eigen::Vector3f>& points) {
    Diagnostic words;
    const auto cut = cutBeside(points, path, settings, words);
    return cut && cut->depth > allowed ? Diagnostic(words, " cuts ", cut->depth, " mm into the scan at ", Place(cut->place)) : Diagnostic();
  };
  const auto requireClear = [&](const std::vector<Eigen::Vector3f>& points, const char* where) {
    if (const Diagnostic cut = cutInto(points); !cut.empty())
      faults.push_back(Diagnostic(cut, where));
  };
  const char* beside = ", beside what is cut";
  requireClear(part.chosen.kept_out, ", where something stands in a keep-out");
  requireClear(others, beside);
  if (const Diagnostic cut = cutInto(part.chosen.beside); !cut.empty()) {
    const std::size_t before = faults.size();
    requireClear(withoutEchoes(part.chosen.beside, *part.whole), beside);
    if (faults.size() == before)
      warnings.push_back(Diagnostic(cut, beside, ": only single points off the surface are there, usually false echoes"));
  }
  requireClear(reference.riddenPoints(), ", where a cluster of points stands on the part");
  return faults;
}

Diagnostic
faultInRaw(const RawScanFigures& raw, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings, double allowed)
{
  Diagnostic words;
  auto cut = cutBeside(raw.means, path, settings, words);
  if (!cut || cut->depth <= allowed + raw.leastMean()) {
    cut = cutBeside(raw.others, path, settings, words);
    if (!cut || cut->depth <= allowed + single_points * raw.noise + raw.fit_error)
      return {};
  }
  return Diagnostic(words, " cuts ", cut->depth, " mm into the raw scan at ", Place(cut->place),
                    ", where smoothing moved it: smooth with a smaller radius");
}
