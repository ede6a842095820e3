// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops with parts cut out, and the pieces that replace them.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Part of a loop that is left out: it starts at begin and has this length, in the loop's direction. */
struct LoopCut {
  std::size_t loop = 0;
  double begin = 0.0, length = 0.0; ///< step-overs
};

/** One end of a cut: the loop arrives at the begin and goes on from the end. */
struct CutEnd {
  std::size_t cut = 0;
  bool at_end = false;
};

/** A piece of path with lengths. */
struct PathPiece {
  Polyline points;
  std::vector<StepOverMetric> metric;

  void add(const Eigen::Vector3d& p, const StepOverMetric& m);
  void reverse();
};

/** Loops, cuts and connectors: a graph in which every end of a cut has one connector, and walking it gives the path. */
class CutLoops {
public:
  explicit CutLoops(const std::vector<ScallopLoop>& loops) : loops_(loops), cuts_of_(loops.size()) {}

  const ScallopLoop& loop(std::size_t i) const { return loops_[i]; }
  std::size_t size() const { return loops_.size(); }
  const LoopCut& cut(std::size_t c) const { return cuts_[c]; }
  /** The pieces added so far. */
  const std::vector<PathPiece>& pieces() const { return pieces_; }

  std::size_t addCut(const LoopCut& cut);
  void connect(const CutEnd& from, const CutEnd& to, PathPiece piece);
  /** Whether the stretch of a loop \p reach to either side of \p u holds no part of a cut. */
  bool isFree(std::size_t loop, double u, double reach) const;
  /** The way back from \p u to the next cut, at most \p limit. */
  double freeBehind(std::size_t loop, double u, double limit) const;

  std::size_t cuts() const { return cuts_.size(); }
  /** Append to \p path the path from the end \p start of a cut to an end without a connector. \return the number of arcs
   *  between cuts on it. If all walks together have fewer arcs than there are cuts, parts of loops are missing. */
  std::size_t walk(const CutEnd& start, LinkedPath& path) const;

private:
  struct Connector {
    std::size_t to = none; ///< end, as 2 cut + at_end
    std::size_t piece = none;
    bool reversed = false;
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  void addArc(std::size_t loop, double from, double length, bool backward, LinkedPath& path) const;

  const std::vector<ScallopLoop>& loops_;
  std::vector<LoopCut> cuts_;
  std::vector<std::vector<std::size_t>> cuts_of_;
  std::vector<Connector> connectors_; ///< two a cut
  std::vector<PathPiece> pieces_;
};

} // namespace pcl_spiral
