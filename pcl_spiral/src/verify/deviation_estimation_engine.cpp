// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/verify/impl/deviation_estimation_engine.h>

#include "common/stoppable_loop.h"
#include "quantile.h"
#include "reference_figures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double rounding = 1e-4; // cosine: along a wall the tool axis is square to the normals of fits, known to about that

/** Sums and extremes over the points, taken in their order. */
class Tally {
public:
  Tally(const ReferenceSurface& reference, const CutterPath& path, DeviationReport& figures)
  : reference_(reference), path_(path), figures_(figures)
  {}

  float take(std::size_t i, const SurfaceFoot& foot)
  {
    if (!path_.lifts.empty() && path_.lifts[i] > 0.0f) {
      ++figures_.lifted;
      raise(figures_.lift_max, path_.lifts[i], path_.contacts[i], i);
      return std::numeric_limits<float>::quiet_NaN();
    }
    if (reference_.inCreaseBand(path_.contacts[i]))
      return takeCrease(i, foot);
    if (!foot.valid) {
      const Eigen::Vector3d& p = path_.contacts[i];
      ++(reference_.inGap(p) ? figures_.in_gaps : isAtRim(p) ? figures_.beyond_rim : figures_.unmeasured);
      return std::numeric_limits<float>::quiet_NaN();
    }
    const Eigen::Vector3d& p = path_.contacts[i];
    const double deviation = (p - foot.position).dot(foot.normal);
    if (reference_.inGap(foot.position)) {
      ++figures_.in_gaps;
      if (std::abs(deviation) > std::abs(figures_.gap_max.value))
        figures_.gap_max = {deviation, p, i};
      return static_cast<float>(deviation);
    }
    takeNormal(i, foot);
    PlacedValue& largest = foot.overhang > 0.0 ? figures_.rim_max : figures_.max;
    if (std::abs(deviation) > std::abs(largest.value))
      largest = {deviation, p, i};
    if (foot.overhang > 0.0)
      ++figures_.beyond_rim;
    else {
      ++figures_.measured;
      squares_ += deviation * deviation;
      amounts_.push_back(static_cast<float>(std::abs(deviation)));
    }
    return static_cast<float>(deviation);
  }

  void finish()
  {
    figures_.rms = amounts_.empty() ? 0.0 : std::sqrt(squares_ / static_cast<double>(amounts_.size()));
    figures_.p99 = quantile(amounts_, 0.99);
    figures_.normal_p99 = quantile(angles_, 0.99);
  }

private:
  /** A contact in the band about a crease is counted separately, because the fit rounds the crease. */
  float takeCrease(std::size_t i, const SurfaceFoot& foot)
  {
    ++figures_.in_crease_band;
    if (!foot.valid)
      return std::numeric_limits<float>::quiet_NaN();
    const double deviation = (path_.contacts[i] - foot.position).dot(foot.normal);
    if (std::abs(deviation) > std::abs(figures_.crease_max.value))
      figures_.crease_max = {deviation, path_.contacts[i], i};
    return std::numeric_limits<float>::quiet_NaN();
  }

  /** Whether a contact without a fit is no farther from the rim of a scan, along the surface, than planners go: the outermost points may
   *  be sparse there. */
  bool isAtRim(const Eigen::Vector3d& p) const
  {
    constexpr double most = 0.5 * 1.01; // spacings; the place of a contact is rounded
    constexpr double bend = 1.0 / 16.0; // spacings: of half a spacing about the tightest radius of a scan, two spacings
    const SurfaceGraph& graph = reference_.graph();
    const std::optional<Eigen::Vector3d> rim = reference_.mesh() ? std::nullopt : reference_.nearestOnRim(p, most * graph.spacing());
    return rim && std::abs((p - *rim).dot(graph.normal(graph.blocks().nearest(p)))) <
                      bend * graph.spacing() + fit_deviations * reference_.fitNoise();
  }

  void takeNormal(std::size_t i, const SurfaceFoot& foot)
  {
    const Eigen::Vector3d& n = path_.normals[i];
    const double cosine = n.dot(foot.normal);
    const double angle = std::atan2(n.cross(foot.normal).norm(), cosine) * 180.0 / pi;
    if (foot.overhang <= 0.0) {
      angles_.push_back(static_cast<float>(angle));
      if (angle > figures_.normal_error.value)
        figures_.normal_error = {angle, path_.contacts[i], i};
    }
    if (cosine < 0.0 && figures_.opposed++ == 0)
      figures_.first_opposed = {angle, path_.contacts[i], i};
    if (!path_.axes.empty() && path_.axes[i].dot(foot.normal) < -rounding && figures_.inward_axes++ == 0)
      figures_.first_inward = {std::acos(std::max(-1.0, path_.axes[i].dot(foot.normal))) * 180.0 / pi, path_.contacts[i], i};
  }

  const ReferenceSurface& reference_;
  const CutterPath& path_;
  DeviationReport& figures_;
  double squares_ = 0.0;
  std::vector<float> amounts_, angles_;
};

void
warn(const ReferenceSurface& reference, DeviationReport& figures)
{
  const auto of = [&](std::size_t count) { return Diagnostic(count, " of ", figures.points, " path points"); };
  if (figures.unmeasured > 0)
    figures.warnings.push_back(
        Diagnostic(of(figures.unmeasured), " have no ", (reference.mesh() ? "surface of the mesh" : "scanned surface"), " near them: ",
                   (2 * figures.unmeasured > figures.points ? "is it another part, or another unit?" : "they cannot be judged there")));
  const bool reversed = 2 * figures.opposed > figures.measured + figures.beyond_rim;
  if (reversed)
    figures.warnings.push_back(Diagnostic("the normals of ", of(figures.opposed),
                                          " point into the material: they are reversed, or the reference is seen from its other "
                                          "side; in that case flip the normals of the reference"));
  else if (figures.opposed > 0)
    figures.warnings.push_back(
        Diagnostic("the normals of ", of(figures.opposed), " point into the material, the first at ", figures.first_opposed.index));
  if (figures.inward_axes > 0 && !reversed)
    figures.warnings.push_back(Diagnostic("the tool axes of ", of(figures.inward_axes), " point into the material, the first at ",
                                          figures.first_inward.index, ": the shank would be inside the part"));
  if (figures.in_gaps > 0)
    figures.warnings.push_back(Diagnostic(of(figures.in_gaps), " lie in gaps of the scan: they cannot be judged there"));
}

} // namespace

Status
measureDeviation(const ReferenceSurface& reference, const CutterPath& path, double chord_error, const ProgressCallback& progress,
                 std::vector<float>& deviation, DeviationReport& figures)
{
  const auto start = std::chrono::steady_clock::now();
  deviation.clear();
  figures = DeviationReport();
  figures.points = path.size();
  figures.by_mesh = reference.mesh() != nullptr;
  describeReference(reference, 0.0, chord_error, figures);
  figures.motion = pathMotion(path);
  deviation.reserve(path.size());
  Tally tally(reference, path, figures);
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < path.size(); begin += report_chunk) {
    const std::size_t end = std::min(path.size(), begin + report_chunk);
    reference.surface().project(
        {path.contacts.begin() + static_cast<std::ptrdiff_t>(begin), path.contacts.begin() + static_cast<std::ptrdiff_t>(end)}, feet);
    for (std::size_t i = begin; i < end; ++i)
      deviation.push_back(tally.take(i, feet[i - begin]));
    if (progress && !progress(static_cast<double>(end) / static_cast<double>(path.size()), "deviation"))
      return {StatusCode::Cancelled, "cancelled"};
  }
  tally.finish();
  figures.wobble = turnWobble(path, deviation);
  warn(reference, figures);
  figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (figures.unmeasured == path.size())
    return {StatusCode::InvalidInput,
            Diagnostic("none of the ", path.size(), " path points lies on the reference: is it another part, or another unit?")};
  return Status::success();
}

} // namespace pcl_spiral
