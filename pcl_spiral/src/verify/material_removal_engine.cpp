// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/material_removal_engine.h>

#include <pcl_spiral/core/impl/tolerances.h>

#include "path_order.h"
#include "quantile.h"
#include "reference_figures.h"
#include "removal_samples.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

namespace pcl_spiral {
namespace {

constexpr std::size_t places_together = 1u << 13; // places between progress reports, where a run can be cancelled
constexpr double fit_share = 5.0;                 // of the noise of the fit: depth of a ball that does not count
constexpr std::size_t block = 32;                 // consecutive places: the move found at one is tried first at the next

/** One measurement, step by step. */
class Measurement {
public:
  Measurement(const ReferenceSurface& reference, const CutterPath& path, const CutterSweep& sweep, const RemovalSettings& settings,
              const ProgressCallback& progress, RemovalHeights& heights, RemovalReport& figures)
  : reference_(reference), path_(path), sweep_(sweep), settings_(settings), progress_(progress), heights_(heights), figures_(figures),
    ball_(makeBall(reference, settings)), sampler_(reference, sweep, settings, figures.reach, ball_.get())
  {}

  bool overReference();
  bool alongPath();
  void finish();

private:
  /** Null: everything is reached. */
  static std::unique_ptr<const BallReach> makeBall(const ReferenceSurface& reference, const RemovalSettings& settings)
  {
    const double radius = settings.corner_radius.value_or(settings.tool_radius);
    const double noise = std::max(reach_share * settings.chord_error, fit_share * reference.fitNoise());
    return radius > 0.0
               ? std::make_unique<BallReach>(reference.graph(), reference.surface(), radius, reachTolerance(reference.surface(), noise),
                                             BallObstacles{reference.scanned().riddenPoints(), ride_share * settings.chord_error})
               : nullptr;
  }
  void count(std::size_t i, const SampleResult& result);
  void finish(StockReport& figures, std::vector<float>& heights, const PlacedValue& max);
  std::vector<float> cutSteps() const;
  void measureEfficiency();

  const ReferenceSurface& reference_;
  const CutterPath& path_;
  const CutterSweep& sweep_;
  const RemovalSettings& settings_;
  const ProgressCallback& progress_;
  RemovalHeights& heights_;
  RemovalReport& figures_;
  std::unique_ptr<const BallReach> ball_;
  RemovalSampler sampler_;
  RemovalExtremes extremes_;
  std::vector<float> main_, ridge_, rim_, crease_, unreached_, steps_;
  std::vector<Eigen::Vector3f> feet_;
};

void
Measurement::count(std::size_t i, const SampleResult& result)
{
  heights_.stock[i] = result.stock;
  heights_.ridge[i] = result.ridge;
  steps_[i] = result.step;
  if (result.zone == Zone::None) {
    ++figures_.unmeasured;
    return;
  }
  const Zone zone = result.zone;
  const auto of = [zone](auto& main, auto& rim, auto& crease, auto& unreached) -> auto&
  {
    return zone == Zone::Crease ? crease : zone == Zone::Unreached ? unreached : zone == Zone::Rim ? rim : main;
  };
  of(main_, rim_, crease_, unreached_).push_back(result.stock);
  if (result.ridge == result.ridge)
    ridge_.push_back(result.ridge);
  if (!result.met) {
    StockReport& figures = of(figures_.stock, figures_.rim, figures_.crease, figures_.unreached);
    if (figures.uncut++ == 0)
      figures.first_uncut = {result.stock, feet_[i].cast<double>(), result.move};
  }
}

bool
Measurement::overReference()
{
  const std::size_t size = reference_.graph().size();
  heights_.stock.resize(size);
  heights_.ridge.resize(size);
  steps_.resize(size);
  feet_.resize(size);
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < size; begin += places_together) {
    const std::size_t end = std::min(size, begin + places_together);
    queries.clear();
    for (std::size_t i = begin; i < end; ++i)
      queries.push_back(reference_.graph().position(i));
    reference_.surface().project(queries, feet);
    for (std::size_t i = begin; i < end; ++i)
      if (reference_.inCreaseBand(queries[i - begin]))
        feet[i - begin] = reference_.meshPlace(i);
    const auto blocks = static_cast<std::ptrdiff_t>((end - begin + block - 1) / block);
    std::vector<SampleResult> results(end - begin);
    std::vector<RemovalExtremes> extremes(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic, 8)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      const std::size_t first = static_cast<std::size_t>(b) * block;
      std::size_t guess = sweep_.moves();
      for (std::size_t k = first; k < std::min(first + block, end - begin); ++k) {
        results[k] = sampler_.at(feet[k], guess, extremes[static_cast<std::size_t>(b)]);
        if (reference_.mesh())
          sampler_.inFace(begin + k, results[k].move, extremes[static_cast<std::size_t>(b)]);
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      feet_[i] = feet[i - begin].position.cast<float>();
      count(i, results[i - begin]);
    }
    for (const RemovalExtremes& e : extremes)
      extremes_.merge(e);
    if (progress_ && !progress_(0.6 * static_cast<double>(end) / static_cast<double>(size), "stock"))
      return false;
  }
  return true;
}

bool
Measurement::alongPath()
{
  const std::size_t moves = sweep_.moves();
  const double longest = 2.0 * reference_.fitRadius(); // of a piece of a move
  struct Station {
    std::size_t move;
    double f;
  };
  std::vector<Station> stations;
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < moves;) {
    stations.clear();
    queries.clear();
    std::size_t end = begin;
    for (; end < moves && stations.size() < places_together; ++end) {
      const Eigen::Vector3d &a = path_.contacts[end], &b = path_.contacts[end + 1];
      const auto pieces = sweep_.isLift(end) ? 1 : static_cast<std::size_t>(std::clamp(std::ceil((b - a).norm() / longest), 1.0, 1e4));
      for (std::size_t k = 0; k < pieces; ++k) {
        const double f = static_cast<double>(k) / static_cast<double>(pieces);
        stations.push_back({end, f});
        queries.push_back((1.0 - f) * a + f * b);
      }
    }
    queries.push_back(path_.contacts[end]);
    reference_.surface().project(queries, feet);
    const auto blocks = static_cast<std::ptrdiff_t>((stations.size() + block - 1) / block);
    std::vector<RemovalExtremes> extremes(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic, 8)
    for (std::ptrdiff_t b = 0; b < blocks; ++b) {
      RemovalExtremes& met = extremes[static_cast<std::size_t>(b)];
      const std::size_t first = static_cast<std::size_t>(b) * block;
      for (std::size_t k = first; k < std::min(first + block, stations.size()); ++k) {
        const Station& station = stations[k];
        if (sweep_.isLift(station.move))
          continue;
        const bool ends = k + 1 == stations.size() || stations[k + 1].move != station.move;
        sampler_.along(station.move, station.f, ends ? 1.0 : stations[k + 1].f, feet[k], feet[k + 1], met);
        if (!feet[k].valid)
          continue;
        // Every ridge has a pass on either side: one finds it at its points, the other between them.
        sampler_.beside(feet[k], station.move, 1.0, met);
        sampler_.beside(shifted(feet[k], 0.5 * (queries[k + 1] - queries[k])), station.move, -1.0, met);
      }
    }
    for (const RemovalExtremes& e : extremes)
      extremes_.merge(e);
    begin = end;
    if (progress_ && !progress_(0.6 + 0.4 * static_cast<double>(end) / static_cast<double>(moves), "moves"))
      return false;
  }
  return true;
}

void
Measurement::finish(StockReport& figures, std::vector<float>& heights, const PlacedValue& max)
{
  figures.samples = heights.size();
  if (heights.empty())
    return;
  figures.max = max;
  const auto above = std::count_if(heights.begin(), heights.end(), [this](float v) { return v > figures_.limit; });
  figures.share_above = static_cast<double>(above) / static_cast<double>(heights.size());
  figures.p50 = quantile(heights, 0.5);
  figures.p90 = quantile(heights, 0.9);
  figures.p99 = quantile(heights, 0.99);
  figures.p999 = quantile(heights, 0.999);
}

/** Step-overs at the points that the path cuts down to the limit, 0 elsewhere. */
std::vector<float>
Measurement::cutSteps() const
{
  const auto most = static_cast<float>(figures_.limit + fit_deviations * reference_.fitNoise());
  std::vector<float> steps = steps_;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!(heights_.stock[i] <= most))
      steps[i] = 0.0f;
  return steps;
}

/** Compares the path with the least length for what it cuts: a part of a path is no better than the whole. */
void
Measurement::measureEfficiency()
{
  const std::vector<float> cut = cutSteps();
  double inside = 0.0, cut_inside = 0.0, with_rim = 0.0;
  leastLength(reference_, steps_, feet_, 0.0, inside);
  leastLength(reference_, cut, feet_, 0.0, cut_inside);
  figures_.area = inside > 0.0 ? inside + reference_.rimStrip() : 0.0;
  figures_.path_length = cutLength(path_);
  const double least = leastLength(reference_, cut, feet_, inside > 0.0 ? cut_inside / inside : 0.0, with_rim);
  figures_.least_length = std::min(least, figures_.path_length); // the path itself cuts these places; its last pass cuts half a step more
  if (figures_.path_length > 0.0)
    figures_.efficiency = figures_.least_length / figures_.path_length;
}

void
Measurement::finish()
{
  figures_.gouge = extremes_.gouge;
  figures_.rim_gouge = extremes_.rim_gouge;
  figures_.face_depth = extremes_.face_depth;
  figures_.face_gouge = extremes_.face_gouge;
  finish(figures_.stock, main_, extremes_.stock);
  finish(figures_.rim, rim_, extremes_.rim);
  finish(figures_.crease, crease_, extremes_.crease);
  finish(figures_.unreached, unreached_, extremes_.unreached);
  if (ball_) {
    figures_.fitting_radius = ball_->radius();
    for (const UnreachedPoint& point : ball_->unreached())
      figures_.fitting_radius = std::min<double>(figures_.fitting_radius, point.reach);
  }
  figures_.crease_gouge = extremes_.crease_gouge;
  finish(figures_.scallop, ridge_, extremes_.scallop);
  figures_.rim_length = reference_.rimLength();
  measureEfficiency();
  if (figures_.gouge.value > settings_.tool_radius)
    figures_.warnings.push_back(Diagnostic("the middle of the cutter is inside the material at path point ", figures_.gouge.index,
                                           ": the path's normals are reversed there, or the reference is seen from its other side"));
}

Status
check(const CutterPath& path, const CutterSweep& sweep, const RemovalSettings& settings)
{
  const auto bad = [](const char* what, double value, const char* remedy) {
    return Status(StatusCode::InvalidArgument, Diagnostic(what, " is ", value, " {mm}; ", remedy));
  };
  if (!(settings.tool_radius > 0.0) || !std::isfinite(settings.tool_radius))
    return bad("the tool radius", settings.tool_radius, "set it above 0: {setToolRadius}");
  if (!(settings.scallop_height > 0.0) || !(settings.scallop_height < settings.tool_radius))
    return bad("the scallop height", settings.scallop_height, "set it above 0 and below the tool radius");
  if (!(settings.chord_error >= 0.0) || !std::isfinite(settings.chord_error))
    return bad("the chord error", settings.chord_error, "set it to 0 or more");
  if (!(settings.reach >= 0.0) || !std::isfinite(settings.reach))
    return bad("the reach", settings.reach, "set it above the scallop height, or to 0 to have it chosen");
  if (path.size() < 2 || sweep.centres().size() != path.size())
    return {StatusCode::InvalidArgument, Diagnostic("the path has ", path.size(), " points and the cutter ", sweep.centres().size(),
                                                    " places: give at least two points, with one place each")};
  return checkOrder(path);
}

} // namespace

Status
measureRemovedMaterial(const ReferenceSurface& reference, const CutterPath& path, const CutterSweep& sweep, const RemovalSettings& settings,
                       const ProgressCallback& progress, RemovalHeights& heights, RemovalReport& figures)
{
  const auto start = std::chrono::steady_clock::now();
  heights = RemovalHeights();
  figures = RemovalReport();
  if (const Status status = check(path, sweep, settings); !status.ok())
    return status;
  describeReference(reference, settings.scallop_height, settings.chord_error, figures);
  figures.limit = 1.02 * settings.scallop_height + settings.chord_error;
  figures.reach = settings.reach > 0.0 ? settings.reach : std::max(20.0 * settings.scallop_height, 10.0 * figures.noise);
  Measurement measurement(reference, path, sweep, settings, progress, heights, figures);
  if (!measurement.overReference() || !measurement.alongPath())
    return {StatusCode::Cancelled, "cancelled"};
  measurement.finish();
  figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return Status::success();
}

} // namespace pcl_spiral
