// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One line on its way to its geodesic.
 */
#pragma once

#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

namespace pcl_spiral {

/** Moves one line, in rounds: it asks for points to be projected and takes their feet. */
class LineRefiner {
public:
  LineRefiner(GeodesicLine& line, const RefinementOptions& options, double spacing)
  : line_(line), options_(options), spacing_(spacing), start_(line.points)
  {}

  /** Feet of the two ends. */
  void begin(const SurfaceFoot& first, const SurfaceFoot& last);
  void startLevel(int segments, bool finest);

  bool active() const { return phase_ != Phase::Done; }
  /** What to project next: the candidate's inner points, or probes beside them. */
  void appendQueries(Polyline& queries) const;
  /** Take the feet of the queries, and go on from there or be done. */
  void take(const SurfaceFoot* inner);

private:
  enum class Phase { Starting, Stepping, Probing, Done };

  void takeStart(std::size_t fault);
  void takeStep(std::size_t fault);
  /** The normal of a fit leans with the change of curvature under it; feet on both sides show the true slope. */
  void takeProbes(const SurfaceFoot* probes);
  void accept();
  /** The next step from where the line is. */
  void chooseMoves();
  /** The next candidate: the line moved by the scaled step, evenly spaced again. */
  void propose();
  void keepCandidate();
  void leave(std::size_t fault);

  /** First point off the surface, or on another sheet than its neighbours; 0 if there is none. */
  std::size_t firstFault() const;
  Eigen::Vector3d conormal(std::size_t i) const;
  /** The line's feet, their normals turned sideways by the slopes found. */
  std::vector<SurfaceFoot> straightened() const;
  /** Of the feet taken last. */
  Polyline positions() const;

  GeodesicLine& line_;
  const RefinementOptions& options_;
  double spacing_;
  Polyline start_, candidate_, moves_;
  SurfaceFoot ends_[2];
  std::vector<SurfaceFoot> feet_;
  std::size_t segments_ = 0;
  bool finest_ = false, refined_ = false;
  Phase phase_ = Phase::Done;
  std::vector<double> slopes_; ///< of the surface across the line against the feet's normals, once probed
  int iterations_ = 0, stalls_ = 0;
  double smallest_move_ = 0.0; ///< asked for so far at this level
  double scale_ = 1.0;
};

} // namespace pcl_spiral
