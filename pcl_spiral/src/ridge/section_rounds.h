// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rail and generator aligned to the sections of a scan, until they stand still.
 */
#pragma once

#include "section_shift.h"

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>

#include <vector>

namespace pcl_spiral {

/** What rounds go by. Lengths in mm. */
struct RoundSettings {
  double noise = 0.0;   ///< of the scan
  double spacing = 0.0; ///< of the scan
  double half_width = 0.0;
  int most_rounds = 30;
};

/** Where along the rail the generator is taken: not the very middle, so that it is clear from which end the rail runs. */
constexpr double meeting_share = 0.45;

/** A ridge as its sections find it. */
class SectionRounds {
public:
  /** \p band with points, rail and chord to begin with; \p generator in local coordinates. */
  SectionRounds(const RoundSettings& settings, RidgeBand band, const SmoothLine& generator);

  /** Rounds until nothing moves. InvalidInput, with place: the rail too steep for the chord, sections without points, no end. */
  Status run(const ProgressCallback& progress);

  const SmoothLine& rail() const { return band_.rail; }
  const SmoothLine& generator() const { return generator_; }
  const RidgeChord& chord() const { return band_.chord; }
  int rounds() const { return rounds_; }
  double lastMove() const { return last_move_; }
  std::size_t sections() const { return count_; }
  /** How the generator lies on each section where the rail has it, and its cells. */
  const Profile& profile() const { return profile_; }
  const RidgeBand& band() const { return band_; }
  std::vector<SectionShift> lying();
  double stationOf(std::size_t section) const { return static_cast<double>(section) * length_; }

private:
  Status place();
  std::vector<SectionShift> shifts(int most_steps);
  Status round();
  double moveSince(const SmoothLine& before) const;
  double stillness(const std::vector<SectionShift>& shifts) const;
  void carryEndsOn(const std::vector<RidgeFrame>& frames, Polyline& origins) const;
  Status moveRail(const std::vector<SectionShift>& shifts, const Eigen::Vector3d& gauge);
  bool meanSection(const std::vector<SectionShift>& shifts, Polyline& points, Eigen::Vector3d& gauge);
  Eigen::Vector3d gaugeOf(const std::vector<SectionShift>& shifts, const Polyline& generator) const;
  void setGenerator(const Polyline& points);
  std::pair<std::size_t, std::size_t> coveredCells(const std::vector<SectionShift>& shifts) const;

  RoundSettings settings_;
  RidgeBand band_;
  StationLine rail_stations_;
  SectionPoints section_points_;
  SmoothLine generator_;
  Profile profile_;
  std::size_t count_ = 0; ///< of sections
  double length_ = 0.0;   ///< of a section
  double last_move_ = 0.0, still_ = 0.0;
  double held_error_ = 0.0; ///< to which the rail is fitted; 0: found anew
  int rounds_ = 0;
  std::size_t first_cell_ = 0, last_cell_ = 0; ///< of the generator, once its ends stand
};

} // namespace pcl_spiral
