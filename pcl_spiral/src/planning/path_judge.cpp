// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/path_judge.h>

#include "planning/part_selection.h"
#include "planning/plan_regions.h"
#include "planning/region_passes.h"
#include "planning/tip_check.h"
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/verify/impl/cutter_contacts.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double share_of_reading = 0.3;   // of the progress, for a path whose surface is needed before it is judged
constexpr double share_of_choosing = 0.25; // of the progress of judging, for what comes before

/** The points \p own of \p path; no arc length is added on the way from pass to pass. */
pcl::PointCloud<ToolpathPoint>
pointsOf(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<std::size_t>& own)
{
  const std::vector<std::size_t> begins = passBegins(path);
  pcl::PointCloud<ToolpathPoint> points;
  double gap = 0.0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const std::size_t i = own[k];
    if (k > 0 && (own[k - 1] + 1 != i || beginsPass(begins, i)))
      gap = points.back().arc_length - path[i].arc_length;
    points.push_back(path[i]);
    points.back().arc_length += gap;
  }
  return points;
}

/** Gives \p path, of tips and axes, the contacts of \p cutter with the surface, and arc lengths along them; where there is no surface, the
 *  tip stays and the axis is the normal. */
void
findContacts(const ReferenceSurface& reference, const CutterShape& cutter, const Polyline& tips, pcl::PointCloud<ToolpathPoint>& path)
{
  std::vector<CutterPlace> places;
  for (std::size_t i = 0; i < path.size(); ++i)
    places.push_back({tips[i], path[i].getAxisVector3fMap().cast<double>()});
  const std::vector<NearestContact> contacts = cutterContacts(reference, places, cutter);
  const std::vector<std::size_t> passes = passBegins(path);
  double length = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    ToolpathPoint& point = path[i];
    if (contacts[i].valid)
      point.getVector3fMap() = contacts[i].position.cast<float>();
    point.getNormalVector3fMap() = contacts[i].valid ? Eigen::Vector3f(contacts[i].normal.cast<float>()) : point.getAxisVector3fMap();
    if (i > 0 && !beginsPass(passes, i))
      length += (point.getVector3fMap() - path[i - 1].getVector3fMap()).cast<double>().norm();
    point.arc_length = length;
  }
}

} // namespace

PathJudge::PathJudge() = default;
PathJudge::~PathJudge() = default;

void
PathJudge::setProgress(const ProgressCallback& progress)
{
  input_.progress = progress ? progress : [](double, const std::string&) { return true; };
}

Status
PathJudge::prepare(const JudgedInput& input, double lean)
{
  input_ = input;
  setProgress(input.progress);
  JudgeSettings& settings = input_.settings;
  settings.view_point = input.surface.view_point;
  settings.trust_normals = input.surface.trust_normals;
  settings.flip_normals = input.surface.flip_normals;
  settings.threads = input.surface.threads;
  settings.largest_part = input.surface.largest_part && !input.surface.part_at;
  parts_.clear();
  passes_.reset();
  if (settings.mesh && input.raw)
    return {StatusCode::InvalidArgument, "{setRawScan} belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out"};
  if (settings.mesh) {
    parts_.emplace_back();
    return checkPartOfMesh(input.choice, input.regions);
  }
  const PartTool tool{settings.cutter.radius, lean};
  for (const PlanRegion& region : namedRegions(input.regions)) {
    const PartChoice choice = choiceOf(input.choice, region);
    JudgedPart part;
    part.region = region.name;
    if (const Status status = choosePart({input.cloud, input.normals, input.surface, input.indices}, choice, tool, {}, part.chosen);
        !status.ok())
      return {status.code(), textOfRegion(region.name, status.diagnostic())};
    part.cloud = part.chosen.cloud ? part.chosen.cloud : input.cloud;
    part.normals = part.chosen.cloud ? part.chosen.normals : input.normals;
    part.chosen.part_at = choice.part_at;
    part.clusters = choice.clusters;
    parts_.push_back(std::move(part));
  }
  if (parts_.size() < 2)
    return Status::success();
  const auto share = [this](std::size_t k) { return static_cast<double>(k) / static_cast<double>(parts_.size()); };
  for (std::size_t region = 0; region < parts_.size(); ++region)
    if (const Status status = makeReference(region, share(region), share(region + 1)); !status.ok())
      return {status.code(), textOfRegion(parts_[region].region, status.diagnostic())};
  passes_ = std::make_unique<RegionPasses>(parts_);
  return Status::success();
}

Status
PathJudge::makeReference(std::size_t region)
{
  return makeReference(region, 0.0, 1.0);
}

Status
PathJudge::makeReference(std::size_t region, double from, double to)
{
  JudgedPart& part = parts_[region];
  const JudgeSettings& settings = input_.settings;
  if (part.reference)
    return Status::success();
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(part.cloud);
  scanned.setStrict(false); // a rough reference is accepted, with a warning
  scanned.setClusterHandling(part.clusters);
  scanned.setFlipNormals(settings.flip_normals);
  scanned.setInputNormals(part.normals);
  scanned.setTrustNormals(settings.trust_normals);
  if (settings.view_point)
    scanned.setViewPoint(*settings.view_point);
  if (part.chosen.part_at)
    scanned.setPartAt(*part.chosen.part_at);
  scanned.setLargestPart(settings.largest_part);
  scanned.setNumberOfThreads(settings.threads);
  scanned.setQuiet(true);
  scanned.setProgressCallback(withStage(partOf(input_.progress, from, to, "reference")));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (scanned.getStatus().ok())
    part.reference = std::make_shared<ReferenceSurface>(surface);
  return scanned.getStatus();
}

Status
PathJudge::readContacts(const GivenPath& given, std::size_t region, JudgedPath& judged)
{
  const JudgedPart& part = parts_[region];
  const CutterShape& cutter = input_.settings.cutter;
  *judged.path = *given.path;
  if (!given.has_contacts) {
    if (!part.cloud)
      return {StatusCode::InvalidInput,
              "the path has tips and axes without contacts, which are found on a scan, and a mesh is given: read its "
              "vertices as a scan ({readCloud})"};
    if (passes_)
      return {StatusCode::InvalidInput, "the path has tips and axes without contacts: give one region at a time"};
    if (const Status status = makeReference(region, 0.0, share_of_reading); !status.ok())
      return status;
    findContacts(*part.reference, cutter, given.tips, *judged.path);
  }
  Polyline tips = given.tips;
  if (passes_) {
    const std::vector<std::size_t> own = passes_->pointsOf(region, *given.path);
    if (own.empty())
      return {StatusCode::InvalidInput, "no pass of the path is on this region; give the regions that the path was made for"};
    *judged.path = pointsOf(*given.path, own);
    tips.clear();
    for (std::size_t k = 0; k < own.size() && !given.tips.empty(); ++k)
      tips.push_back(given.tips[own[k]]);
  }
  if (given.has_contacts)
    if (const Diagnostic warning = checkTips(*judged.path, tips, cutter, judged.verification); !warning.empty())
      judged.verification.removal.warnings.push_back(warning);
  judged.tips = isBall(cutter) ? Polyline() : std::move(tips);
  return Status::success();
}

Status
PathJudge::read(const GivenPath& given, std::size_t region, JudgedPath& judged)
{
  judged.verification.region = parts_[region].region;
  return given.program ? readProgram(*given.program, region, judged) : readContacts(given, region, judged);
}

Status
PathJudge::judge(const GivenPath& given, std::size_t region, JudgedPath& judged)
{
  JudgedPart& part = parts_[region];
  if (const Status status = read(given, region, judged); !status.ok())
    return status;
  JudgeSettings settings = input_.settings;
  settings.tips = judged.tips;
  settings.normals = part.normals;
  settings.part_at = part.chosen.part_at;
  settings.clusters = part.clusters;
  if (settings.mesh && settings.mesh->report().closed) // only the faces that the path touches are judged
    part.reference.reset();
  const double begin = given.program || !given.has_contacts ? share_of_reading : 0.0;
  const Diagnostics of_file = std::move(judged.verification.removal.warnings);
  const auto judgeBy = settings.cutter.radius > 0.0 ? judgePath : judgeDeviation;
  if (const Status status = judgeBy(part.cloud, judged.path, settings, partOf(input_.progress, begin, 1.0), part.reference,
                                    judged.verification, judged.heights);
      !status.ok())
    return status;
  Diagnostics& warnings = judged.verification.removal.warnings;
  warnings.insert(warnings.begin(), of_file.begin(), of_file.end());
  if (!(settings.cutter.radius > 0.0))
    return Status::success();
  if (input_.raw && !part.raw) {
    RawScanReport raw;
    if (const Status status = compareRawScan(*input_.raw, part.reference->scanned(), raw); !status.ok())
      return {status.code(), Diagnostic(input_.raw_name, ": ", status.diagnostic())};
    part.raw = std::move(raw);
  }
  const JudgedSurroundings around{part.chosen.keep_outs, part.chosen.kept_out, part.chosen.beside, input_.cloud};
  addVerdicts(input_.limits, around, *part.reference, judged.path, settings, part.raw ? &*part.raw : nullptr, input_.raw_name,
              judged.verification);
  return Status::success();
}

Status
toolLean(const JudgedInput& input, const GivenPath& given, double& lean, bool& of_scan)
{
  const SpiralSettings usual;
  lean = 0.0;
  of_scan = false;
  if (input.choice.keep_outs.empty() || input.settings.mesh)
    return Status::success();
  if (!given.program && given.has_contacts) {
    lean = leanOf(*given.path);
    return Status::success();
  }
  lean = usual.tilt_angle + usual.axis_deviation;
  if (input.regions.size() > 1)
    return Status::success();
  PathJudge upright; // leaves no place out
  JudgedPath judged;
  of_scan = true;
  if (const Status status = upright.prepare(input, 0.0); !status.ok())
    return status;
  if (const Status status = upright.makeReference(0); !status.ok())
    return status;
  of_scan = false;
  const Status status = upright.read(given, 0, judged);
  lean = leanOf(*judged.path);
  return status;
}

namespace {

Status
checkJudging(const JudgedInput& input, const GivenPath& given)
{
  if (given.program && given.program->program.blocks.empty())
    return {StatusCode::InvalidInput, "the program is empty: call {setInputProgram} with one that has moves"};
  if (given.program && !given.program->lines.empty() && given.program->lines.size() != given.program->program.blocks.size())
    return {StatusCode::InvalidInput, Diagnostic("the program has ", given.program->program.blocks.size(), " blocks and ",
                                                 given.program->lines.size(), " lines: give one line for each block, or none")};
  if (!given.program && (!given.path || given.path->empty()))
    return {StatusCode::InvalidInput, "the path is missing or empty: call {setInputToolpath} with points"};
  const bool may_lack = given.program || (given.has_contacts && given.tips.empty());
  if (!may_lack && given.tips.size() != given.path->size())
    return {StatusCode::InvalidInput, Diagnostic("the path has ", given.path->size(), " points and ", given.tips.size(),
                                                 " tips: give one tip for each point ({setInputTips})")};
  if (given.program && input.settings.mesh)
    return {StatusCode::InvalidArgument, "a program is judged by the points of a scan, and a mesh is given: give its vertices as a scan "
                                         "({setInputCloud})"};
  if (!(input.settings.cutter.radius > 0.0))
    return {StatusCode::InvalidArgument, "the cutter is missing: call {setCutter}, such as with CutterShape::ball(6.0)"};
  Limits limits = input.limits;
  JudgeSettings settings = input.settings;
  if (const Diagnostic fault = faultOf(settingTable(settings) + settingTable(limits)); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  if (input.surface.thinning > 0.0 || input.surface.outlier_neighbours > 0)
    return {StatusCode::InvalidArgument, Diagnostic(input.surface.thinning > 0.0 ? "{setThinning}" : "{setOutlierRemoval}",
                                                    " was called, but a path is judged by all points of the scan: leave it out")};
  return Status::success();
}

} // namespace

Status
verifyPath(const JudgedInput& input, const GivenPath& given, PathJudge& judge, std::vector<JudgedPath>& judged)
{
  if (const Status status = checkJudging(input, given); !status.ok())
    return status;
  double lean = 0.0;
  bool of_scan = false;
  JudgedInput choosing = input;
  choosing.progress = partOf(input.progress, 0.0, 0.5 * share_of_choosing);
  if (const Status status = toolLean(choosing, given, lean, of_scan); !status.ok())
    return status;
  choosing.progress = partOf(input.progress, 0.5 * share_of_choosing, share_of_choosing);
  if (const Status status = judge.prepare(choosing, lean); !status.ok())
    return status;
  const std::size_t regions = judge.parts().size();
  judged.resize(regions);
  for (std::size_t region = 0; region < regions; ++region) {
    judge.setProgress(progressOf(partOf(input.progress, share_of_choosing, 1.0), region, regions));
    if (const Status status = judge.judge(given, region, judged[region]); !status.ok())
      return {status.code(), textOfRegion(judge.parts()[region].region, status.diagnostic())};
  }
  return Status::success();
}

} // namespace pcl_spiral
