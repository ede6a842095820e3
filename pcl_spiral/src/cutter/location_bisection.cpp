// SPDX-License-Identifier: BSD-3-Clause
#include "location_thinning.h"

#include "common/available_memory.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace pcl_spiral {
namespace {

/** A pass that grows. */
struct OpenPass {
  ToolLocations locations;
  std::vector<std::int8_t> halvings; ///< of the move that begins at each location; the value settled: no more are needed
  std::vector<std::uint8_t> given;
};

constexpr std::int8_t settled = -1;

/** A move to judge. */
struct OpenMove {
  std::size_t pass = 0, from = 0;
  double error = 0.0;
};

bool
isKnown(const ToolLocation& location)
{
  return location.state != LocationState::NoCloud;
}

DrivePoint
middleOf(const ToolLocation& a, const ToolLocation& b)
{
  const Eigen::Vector3d sum = a.axis + b.axis;
  return {0.5 * (a.tip + b.tip), sum.norm() > 1e-9 ? sum : a.axis, Eigen::Vector3d::Zero()};
}

class Bisection {
public:
  Bisection(const CutterLocationEngine& locator, const BisectionSettings& settings, const std::vector<ToolLocations>& passes)
  : locator_(locator), settings_(settings)
  {
    for (const ToolLocations& pass : passes)
      open_.push_back({pass, std::vector<std::int8_t>(pass.size(), 0), std::vector<std::uint8_t>(pass.size(), 1)});
  }

  Status run(const ProgressCallback& progress)
  {
    for (int round = 0; round <= settings_.most_halvings; ++round) {
      const double share = static_cast<double>(round) / (settings_.most_halvings + 1);
      const ProgressCallback inside = [&](double, const std::string&) { return !progress || progress(share, "bisection"); };
      std::vector<OpenMove> moves = openMoves();
      if (moves.empty())
        break;
      if (const Status status = checkSize(moves.size()); !status.ok())
        return status;
      DrivePoints middles;
      for (const OpenMove& move : moves)
        middles.push_back(middleOf(from(move), to(move)));
      ToolLocations located;
      if (const Status status = locator_.locate(middles, inside, located); !status.ok())
        return status;
      judge(moves, located);
      insert(moves, located);
    }
    for (OpenPass& pass : open_)
      thin(pass);
    return Status::success();
  }

  void take(std::vector<ToolLocations>& passes, BisectionReport& figures)
  {
    for (std::size_t p = 0; p < passes.size(); ++p) {
      figures_.inserted += open_[p].locations.size() - passes[p].size();
      passes[p] = std::move(open_[p].locations);
    }
    figures_.largest_error += thinned_by_;
    figures = figures_;
  }

private:
  /** Whether memory is enough for a round with this many middles, if all of them are kept. */
  Status checkSize(std::size_t moves) const
  {
    std::size_t locations = moves;
    for (const OpenPass& pass : open_)
      locations += pass.locations.size();
    constexpr double copies = 3.0; // the passes, the refined passes, the middles
    const double bytes = copies * static_cast<double>(locations * sizeof(ToolLocation));
    const std::optional<double> free_bytes = availableMemory();
    if (static_cast<double>(locations) <= most_path_points && (!free_bytes || bytes <= *free_bytes))
      return Status::success();
    return {StatusCode::InvalidArgument,
            Diagnostic("a tolerance of ", settings_.tolerance, " {mm} between locations needs more than ", locations, " locations, ",
                       bytes / 1e9, " GB: raise the tolerance, or set passes farther apart")};
  }

  const ToolLocation& from(const OpenMove& move) const { return open_[move.pass].locations[move.from]; }
  const ToolLocation& to(const OpenMove& move) const { return open_[move.pass].locations[move.from + 1]; }

  std::vector<OpenMove> openMoves()
  {
    std::vector<OpenMove> moves;
    for (std::size_t p = 0; p < open_.size(); ++p)
      for (std::size_t i = 0; i + 1 < open_[p].locations.size(); ++i) {
        std::int8_t& halvings = open_[p].halvings[i];
        if (halvings == settled)
          continue;
        const ToolLocation &a = open_[p].locations[i], &b = open_[p].locations[i + 1];
        if (isKnown(a) && isKnown(b)) {
          moves.push_back({p, i});
          continue;
        }
        halvings = settled;
        ++figures_.not_judged;
      }
    return moves;
  }

  /** Find how deep \p moves cut, or how much they leave in their middles. */
  void judge(std::vector<OpenMove>& moves, const ToolLocations& middles) const
  {
#pragma omp parallel for schedule(dynamic, 64)
    for (std::int64_t m = 0; m < static_cast<std::int64_t>(moves.size()); ++m) {
      const ToolLocation &a = from(moves[m]), &b = to(moves[m]);
      const double left = isKnown(middles[m]) ? leftAbove(moves[m], middles[m]) : 0.0;
      const double allowed = std::max(left, 0.5 * settings_.tolerance);
      moves[m].error = std::max(left, locator_.moveError({a.tip, a.axis}, {b.tip, b.axis}, allowed));
    }
  }

  /** Halve those of \p moves with too large an error. */
  void insert(const std::vector<OpenMove>& moves, const ToolLocations& middles)
  {
    std::vector<OpenPass> next(open_.size());
    std::size_t m = 0;
    for (std::size_t p = 0; p < open_.size(); ++p)
      for (std::size_t i = 0; i < open_[p].locations.size(); ++i) {
        std::int8_t halvings = open_[p].halvings[i];
        const bool judged = m < moves.size() && moves[m].pass == p && moves[m].from == i;
        const bool halved = judged && isHalved(moves[m], middles[m], halvings);
        halvings = halved ? static_cast<std::int8_t>(halvings + 1) : settled;
        next[p].locations.push_back(open_[p].locations[i]);
        next[p].halvings.push_back(halvings);
        next[p].given.push_back(open_[p].given[i]);
        if (halved) {
          next[p].locations.push_back(middles[m]);
          next[p].halvings.push_back(halvings);
          next[p].given.push_back(0);
        }
        m += judged;
      }
    open_ = std::move(next);
  }

  bool isHalved(const OpenMove& move, const ToolLocation& middle, int halvings)
  {
    const Eigen::Vector3d straight = 0.5 * (from(move).tip + to(move).tip);
    const bool kept = move.error <= 0.5 * settings_.tolerance;
    if (!kept && isKnown(middle) && halvings < settings_.most_halvings)
      return true;
    figures_.unresolved += !kept;
    if (!(move.error <= figures_.largest_error)) {
      figures_.largest_error = move.error;
      figures_.worst_place = straight;
    }
    return false;
  }

  /** How far the cutter passes above \p middle along the axis, but at most the length of the move across the axis, which is less
   *  at a wall. */
  double leftAbove(const OpenMove& move, const ToolLocation& middle) const
  {
    const Eigen::Vector3d way = to(move).tip - from(move).tip;
    const double above = (0.5 * (from(move).tip + to(move).tip) - middle.tip).dot(middle.axis);
    return std::min(above, way.cross(middle.axis).norm());
  }

  /** The moves use half of the tolerance. Remove inserted locations that move the cutter by at most the other
   *  half. */
  void thin(OpenPass& pass)
  {
    const CutterProfile& cutter = locator_.profile();
    std::vector<CutterPlace> places;
    for (const ToolLocation& location : pass.locations)
      places.push_back({location.tip, location.axis});
    const std::vector<std::uint8_t> kept =
        keptPlaces(places, pass.given, std::hypot(cutter.topHeight(), cutter.radius()), 0.5 * settings_.tolerance, thinned_by_);
    std::size_t left = 0;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i])
        pass.locations[left++] = pass.locations[i];
    pass.locations.resize(left);
  }

  const CutterLocationEngine& locator_;
  BisectionSettings settings_;
  std::vector<OpenPass> open_;
  double thinned_by_ = 0.0;
  BisectionReport figures_;
};

} // namespace

Status
bisectLocations(const CutterLocationEngine& locator, const BisectionSettings& settings, const ProgressCallback& progress,
                std::vector<ToolLocations>& passes, BisectionReport& figures)
{
  if (!(settings.tolerance > 0.0) || !std::isfinite(settings.tolerance))
    return {StatusCode::InvalidArgument, Diagnostic("the tolerance between locations is ", settings.tolerance, " {mm}; set it above 0")};
  if (settings.most_halvings < 1 || settings.most_halvings > 30)
    return {StatusCode::InvalidArgument, Diagnostic("the limit of halvings is ", settings.most_halvings, "; set it between 1 and 30")};
  Bisection bisection(locator, settings, passes);
  if (const Status status = bisection.run(progress); !status.ok())
    return status;
  bisection.take(passes, figures);
  return Status::success();
}

} // namespace pcl_spiral
