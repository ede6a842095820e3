// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds where a beam is on along a program that was read back.
 */
#pragma once

#include <pcl_spiral/machine/impl/tool_pose.h>

#include "core/angle_between.h"
#include "support/parsed_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral::test {

inline const std::string on_code = "M62 P0", off_code = "M63 P0";

/** Moves with the beam on: the beam switches on at the end of move on - 1, and off at the end of move off - 1. */
struct Beam {
  std::size_t on, off;
};

inline bool
isAt(const TipAndAxis& found, const TipAndAxis& asked)
{
  return (found.tip - asked.tip).norm() < 1e-3 && angleBetween(found.axis, asked.axis) < 1e-3 * M_PI / 180.0;
}

inline TipAndAxis
placeOf(const ToolPose& pose)
{
  return {pose.tip, pose.axis};
}

inline double
distanceTo(const std::vector<ToolPoses>& rows, const Eigen::Vector3d& p)
{
  double least = 1e9;
  for (const ToolPoses& row : rows)
    for (std::size_t i = 1; i < row.size(); ++i) {
      const Eigen::Vector3d &a = row[i - 1].tip, way = row[i].tip - a;
      least = std::min(least, (p - a - std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0) * way).norm());
    }
  return least;
}

/** With the beam off, no move from \p begin to before \p end brings the tool near the rows. */
inline void
expectOffRows(const std::vector<TipAndAxis>& way, std::size_t begin, std::size_t end, const std::vector<ToolPoses>& rows)
{
  for (std::size_t i = begin; i < end; ++i)
    EXPECT_GT(distanceTo(rows, way[i].tip), 1.0) << "move " << i;
}

/** The moves of \p beam stay on \p row; \p next is its first pose not yet passed. */
inline void
expectOnRow(const ParsedProgram& program, const std::vector<TipAndAxis>& way, const Beam& beam, const ToolPoses& row, std::size_t& next)
{
  for (std::size_t i = beam.on - 1; i < beam.off; ++i) {
    EXPECT_TRUE(i < beam.on || !program.moves[i].rapid) << "move " << i;
    EXPECT_LT(distanceTo({row}, way[i].tip), 0.003) << "move " << i;
    if (next < row.size() && isAt(way[i], placeOf(row[next])))
      ++next;
  }
}

/** All beams of a program, in order; a test fails if they are not successive pairs. */
inline std::vector<Beam>
beamsOf(const ParsedProgram& program)
{
  const std::vector<std::size_t> on = program.placesOf(on_code), off = program.placesOf(off_code);
  std::vector<Beam> beams;
  EXPECT_EQ(on.size(), off.size());
  for (std::size_t i = 0; i < std::min(on.size(), off.size()); ++i) {
    EXPECT_GT(on[i], i > 0 ? off[i - 1] : 0) << "on while it is on, or where the tool never came";
    EXPECT_GT(off[i], on[i]);
    beams.push_back({on[i], off[i]});
  }
  return beams;
}

/** Together the beams pass every pose of the rows in order, to 1e-3 mm and 1e-3 degrees, each row from first to last, and stay
 *  on the rows; with the beam off, the tool is off the rows. \return how many times a row was interrupted and continued */
inline std::size_t
expectBeamsOnRows(const Machine& machine, const ParsedProgram& program, const std::vector<ToolPoses>& rows)
{
  SCOPED_TRACE(machine.name);
  std::vector<TipAndAxis> way;
  for (const ParsedMove& move : program.moves)
    way.push_back(where(machine, move));
  std::size_t row = 0, next = 0, broken = 0, off = 0;
  for (const Beam& beam : beamsOf(program)) {
    if (row == rows.size()) {
      ADD_FAILURE() << "more beams than rows";
      break;
    }
    expectOffRows(way, off, beam.on - 1, rows);
    broken += next > 0; // then the row continues where it was interrupted
    EXPECT_TRUE(isAt(way[beam.on - 1], next > 0 ? way[off - 1] : placeOf(rows[row][0]))) << "row " << row;
    expectOnRow(program, way, beam, rows[row], next);
    off = beam.off;
    if (next == rows[row].size()) {
      EXPECT_TRUE(isAt(way[off - 1], placeOf(rows[row].back()))) << "row " << row;
      ++row;
      next = 0;
    }
  }
  EXPECT_EQ(row, rows.size()) << "pose " << next << " is not on the way of a beam";
  expectOffRows(way, off, way.size(), rows);
  return broken;
}

} // namespace pcl_spiral::test
