// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Aligns rail and generator to the sections of a scan until they converge.
 */
#pragma once

#include "section_shift.h"

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>

#include <vector>

namespace pcl_spiral {

/** Settings of the rounds. Lengths in mm. */
struct RoundSettings {
  double noise = 0.0;   ///< of the scan
  double spacing = 0.0; ///< of the scan
  double half_width = 0.0;
  int most_rounds = 30;
};

/** Place of the generator along the rail: not exactly the middle, so that it is clear at which end the rail begins. */
constexpr double meeting_share = 0.45;

/** A ridge found from its sections. */
class SectionRounds {
public:
  /** \p band: points, rail and chord to start from; \p generator in local coordinates. */
  SectionRounds(const RoundSettings& settings, SectionBand band, const SmoothLine& generator);

  /** Rounds until nothing moves. InvalidInput with the place: rail too steep for the chord, sections without points, no convergence. */
  Status run(const ProgressCallback& progress);

  const SmoothLine& rail() const { return band_.rail; }
  const SmoothLine& generator() const { return generator_; }
  const RidgeChord& chord() const { return band_.chord; }
  int rounds() const { return rounds_; }
  double lastMove() const { return last_move_; }
  std::size_t sections() const { return count_; }
  /** The generator as it lies on each section at the rail, and its cells. */
  const Profile& profile() const { return profile_; }
  const SectionBand& band() const { return band_; }
  std::vector<SectionShift> unmoved();
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
  SectionBand band_;
  StationLine rail_stations_;
  SectionPoints section_points_;
  SmoothLine generator_;
  Profile profile_;
  std::size_t count_ = 0; ///< of sections
  double length_ = 0.0;   ///< of a section
  double last_move_ = 0.0, still_ = 0.0;
  double held_error_ = 0.0; ///< error to which the rail is fitted; 0: found again
  int rounds_ = 0;
  std::size_t first_cell_ = 0, last_cell_ = 0; ///< of the generator, after its ends are fixed
};

} // namespace pcl_spiral
