// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/path_judging.h>

#include "collision/ball_way.h"
#include "planning/part_selection.h"
#include "verify/limit_verdicts.h"
#include "verify/path_ridges.h"
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>
#include <pcl_spiral/verify/material_removal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>

namespace pcl_spiral {
namespace {

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

template <typename Judge>
void
prepare(Judge& judge, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
        const JudgeSettings& settings)
{
  if (settings.mesh) {
    judge.setInputMesh(settings.mesh);
    judge.setSampleSpacing(settings.sample_spacing);
  }
  else
    judge.setInputCloud(scan);
  if (settings.surface)
    judge.setInputSurface(settings.surface);
  judge.setInputToolpath(path);
  judge.setChordError(settings.chord_error);
  judge.setQuiet(true);
  judge.setNumberOfThreads(settings.threads);
  if (settings.surface || settings.mesh)
    return; // oriented already
  if (settings.part_at)
    judge.setPartAt(*settings.part_at);
  judge.setLargestPart(settings.largest_part);
  judge.setClusterHandling(settings.clusters);
  judge.setFlipNormals(settings.flip_normals);
  judge.setInputNormals(settings.normals);
  judge.setTrustNormals(settings.trust_normals);
  if (settings.view_point)
    judge.setViewPoint(*settings.view_point);
}

std::vector<float>
intensities(const pcl::PointCloud<pcl::PointXYZI>& cloud)
{
  std::vector<float> values;
  for (const pcl::PointXYZI& point : cloud)
    values.push_back(point.intensity);
  return values;
}

/** The points that heights belong to: those of the scan, or the samples of the mesh. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
judgedPoints(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const ReferenceSurface& reference)
{
  if (!reference.mesh())
    return scan;
  const auto samples = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const pcl::PointNormal& sample : *reference.mesh()->samples())
    samples->emplace_back(sample.x, sample.y, sample.z);
  return samples;
}

} // namespace

std::vector<Setting>
settingTable(JudgeSettings& s)
{
  return {
      Setting("scallop", "setScallopHeight", "scallop height", "scallop height that the path was made for", "0.02", s.scallop_height)
          .in("mm", NumberRange::above(0.0)),
      Setting("chord_error", "setChordError", "chord error", "chord error that the path was made for", "0.002", s.chord_error)
          .in("mm", NumberRange::above(0.0)),
      Setting("sample_spacing", "setSampleSpacing", "sample spacing", "distance of the points where a mesh is judged", "0.2",
              s.sample_spacing)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("the distance found from area and curvature"),
  };
}

Status
judgeDeviation(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
               const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
               Verification& verification, Heights& heights)
{
  pcl::PointCloud<pcl::PointXYZI> values;
  DeviationEstimation<pcl::PointXYZ> deviation;
  prepare(deviation, scan, path, settings);
  deviation.setReferenceSurface(reference);
  deviation.setProgressCallback([&](double share, const std::string&) { return progress(share, "deviation"); });
  deviation.compute(values);
  if (deviation.getStatus().ok()) {
    reference = deviation.getReferenceSurface();
    heights.points = judgedPoints(scan, *reference);
    heights.deviation = intensities(values);
    verification.deviation = deviation.getReport();
    verification.side = reference->scanned().side();
  }
  return deviation.getStatus();
}

Status
judgePath(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
          const JudgeSettings& settings, const ProgressCallback& progress, std::shared_ptr<const ReferenceSurface>& reference,
          Verification& verification, Heights& heights)
{
  const auto start = std::chrono::steady_clock::now();
  const Status status = judgeDeviation(
      scan, path, settings, [&](double share, const std::string& stage) { return progress(0.3 * share, stage); }, reference, verification,
      heights);
  if (!status.ok())
    return status;
  pcl::PointCloud<pcl::PointXYZI> values;
  MaterialRemoval<pcl::PointXYZ> removal;
  prepare(removal, scan, path, settings);
  removal.setReferenceSurface(reference);
  removal.setCutter(settings.cutter);
  removal.setInputTips(settings.tips);
  removal.setScallopHeight(settings.scallop_height);
  removal.setProgressCallback([&](double share, const std::string&) { return progress(0.3 + 0.7 * share, "removed material"); });
  removal.compute(values);
  heights.stock = intensities(values);
  heights.ridges = removal.getRidgeHeights();
  verification.removal = removal.getReport();
  if (removal.getStatus().ok())
    heights.scallop = ridgesAlong(*path, values, heights.ridges);
  verification.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return removal.getStatus();
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
faultsBeside(const JudgedSurroundings& around, const Surface& reference, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
             const JudgeSettings& settings, double allowed, Diagnostics& warnings)
{
  Diagnostics faults;
  const char* cutter = isBall(settings.cutter) ? "ball" : "cutter";
  std::optional<BallEntry> entry;
  if (!around.keep_outs.empty())
    for (const auto& way : keptOutWays(*path, settings.cutter, settings.tips))
      if (const auto found = deepestEntry(*path, way, settings.cutter.radius, around.keep_outs);
          found && (!entry || found->depth > entry->depth))
        entry = found;
  if (entry)
    faults.push_back(Diagnostic("the ", cutter, " enters a keep-out by ", entry->depth, " {mm} at ", Place(entry->place)));
  std::vector<Eigen::Vector3f> others;
  for (std::size_t i = 0; around.whole && i < reference.leftOut().why.size(); ++i)
    if (reference.leftOut().why[i] == LeftOut::OtherPart)
      others.push_back(reference.leftOut().positions[i]);
  const auto cutInto = [&](const std::vector<Eigen::Vector3f>& points) {
    Diagnostic words;
    const auto cut = cutBeside(points, path, settings, words);
    return cut && cut->depth > allowed ? Diagnostic(words, " cuts ", cut->depth, " {mm} into the scan at ", Place(cut->place))
                                       : Diagnostic();
  };
  const auto requireClear = [&](const std::vector<Eigen::Vector3f>& points, const char* where) {
    if (const Diagnostic cut = cutInto(points); !cut.empty())
      faults.push_back(Diagnostic(cut, where));
  };
  const char* beside = ", beside what is cut";
  requireClear(around.kept_out, ", where something stands in a keep-out");
  requireClear(others, beside);
  if (const Diagnostic cut = cutInto(around.beside); !cut.empty()) {
    const std::size_t before = faults.size();
    requireClear(withoutEchoes(around.beside, *around.whole), beside);
    if (faults.size() == before)
      warnings.push_back(Diagnostic(cut, beside, ": only single points off the surface are there, usually false echoes"));
  }
  requireClear(reference.riddenPoints(), ", where a cluster of points stands on the part");
  return faults;
}

Status
compareRawScan(const pcl::PointCloud<pcl::PointXYZ>& raw, const Surface& smoothed, RawScanReport& figures)
{
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : raw)
    points.push_back(p.getVector3fMap());
  if (points.empty())
    return {StatusCode::InvalidInput, "the raw scan has no points"};
  figures = compareWithRaw(smoothed, points);
  if (2 * figures.points >= std::min(points.size(), smoothed.size())) // the surface may be of one region of the raw scan
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic(points.size() - figures.points, " of ", points.size(),
                                               " points of this raw scan have no smoothed surface near: is it another part, another "
                                               "unit, or are its columns others?")};
}

Diagnostic
faultInRaw(const RawScanReport& raw, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings, double allowed)
{
  Diagnostic words;
  auto cut = cutBeside(raw.means, path, settings, words);
  if (!cut || cut->depth <= allowed + raw.leastMean()) {
    cut = cutBeside(raw.others, path, settings, words);
    if (!cut || cut->depth <= allowed + point_deviations * raw.noise + raw.fit_error)
      return {};
  }
  return Diagnostic(words, " cuts ", cut->depth, " {mm} into the raw scan at ", Place(cut->place),
                    ", where smoothing moved it: smooth with a smaller radius");
}

void
addVerdicts(const Limits& limits, const JudgedSurroundings& around, const ReferenceSurface& reference,
            const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const JudgeSettings& settings, const RawScanReport* raw,
            const std::string& raw_name, Verification& verification)
{
  verification.broken = brokenLimits(limits, verification);
  if (!limits.any() && !verification.program) // the contacts of a program are the judge's own
    for (const Diagnostic& fault : faultsOfPoses(verification))
      verification.broken.push_back(fault);
  const double allowed = gougeTolerance(settings.chord_error, reference.noise());
  for (const Diagnostic& fault : faultsBeside(around, reference.scanned(), path, settings, allowed, verification.removal.warnings))
    verification.broken.push_back(fault);
  if (raw) {
    verification.removal.warnings.push_back(smoothingText(*raw, raw_name));
    if (const Diagnostic fault = faultInRaw(*raw, path, settings, limits.gouge.value_or(allowed)); !fault.empty())
      verification.broken.push_back(fault);
  }
  verification.unproven = unprovenLimits(limits, verification);
}

} // namespace pcl_spiral
