// SPDX-License-Identifier: BSD-3-Clause
#include "line_rounds.h"

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr int most_rounds = 7;               // of halving the gaps between lines
constexpr double closest_in_spacings = 0.75; // lines at the rim
constexpr double predictable = 0.5;          // spacings: a prediction that was off by less in a gap twice as wide is a start

} // namespace

LineRounds::LineRounds(const RadialLineRequest& request, const RimCurve& rim, LineSource& source)
: request_(request), rim_(rim), source_(source), places_(coarsePlaces(rim))
{}

Status
LineRounds::run()
{
  if (const Status status = make(places_, {}, lines_); !status.ok())
    return status;
  for (int round = 1;; ++round) {
    if (request_.progress && !request_.progress(static_cast<double>(round) / (most_rounds + 1)))
      return {StatusCode::Cancelled, "cancelled"};
    chooseGaps(round);
    if (wanted_.empty() || round > most_rounds)
      return Status::success();
    std::vector<RadialLine> added;
    if (const Status status = make(wanted_, std::move(guesses_), added); !status.ok())
      return status;
    judge(added);
    insert(std::move(added));
  }
}

Status
LineRounds::make(const std::vector<LinePlace>& places, std::vector<Polyline> guesses, std::vector<RadialLine>& lines)
{
  Polyline ends;
  for (const LinePlace& place : places)
    ends.push_back(rim_.at(place.s));
  const Status status = source_.make(ends, std::move(guesses), lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].rim_share = places[i].s / rim_.length();
    lines[i].corner = places[i].corner;
    lines[i].level = places[i].level;
  }
  return status;
}

void
LineRounds::chooseGaps(int round)
{
  // In half the gap, the prediction of smooth lines is at least four times better.
  const double settled = (source_.takesGuesses() ? 4.0 : 1.0) * request_.tolerance;
  const double spacing = request_.surface.graph().spacing();
  wanted_.clear();
  guesses_.clear();
  gaps_.clear();
  largest_error_ = 0.0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const LineGap gap(places_, rim_, i);
    const double rim_error = gap.rimError(rim_);
    largest_error_ = std::max({largest_error_, rim_error, places_[i].misfit / 16.0});
    if ((places_[i].misfit <= settled && rim_error <= request_.tolerance) || gap.width() < 2.0 * closest_in_spacings * spacing)
      continue;
    wanted_.push_back({gap.middle(), false, round});
    gaps_.push_back(i);
    guesses_.emplace_back();
    if (source_.takesGuesses() && places_[i].surprise < predictable * spacing)
      guesses_.back() = gap.predicted(lines_, rim_);
  }
}

void
LineRounds::judge(const std::vector<RadialLine>& added)
{
  jump_ = 0.0;
  for (std::size_t a = 0; a < wanted_.size(); ++a) {
    wanted_[a].surprise = LineGap(places_, rim_, gaps_[a]).surprise(lines_, added[a], wanted_[a].misfit);
    if (wanted_[a].surprise > jump_) {
      jump_ = wanted_[a].surprise;
      jump_place_ = added[a].feet[added[a].feet.size() / 2].position;
    }
  }
}

void
LineRounds::insert(std::vector<RadialLine> added)
{
  std::vector<LinePlace> places;
  std::vector<RadialLine> lines;
  for (std::size_t i = 0, a = 0; i < places_.size(); ++i) {
    places.push_back(places_[i]);
    lines.push_back(std::move(lines_[i]));
    if (a == gaps_.size() || gaps_[a] != i)
      continue;
    places.back().misfit = wanted_[a].misfit; // both halves of the gap begin with what is known of the whole
    places.back().surprise = wanted_[a].surprise;
    places.push_back(wanted_[a]);
    lines.push_back(std::move(added[a++]));
  }
  places_.swap(places);
  lines_.swap(lines);
}

} // namespace pcl_spiral
