// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Readers of control programs, independent of the library's writers: one per language.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** One move as the control reads it. */
struct ParsedMove {
  bool rapid = false;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  std::map<char, double> degrees;        ///< of rotary axes, by letter
  std::optional<Eigen::Vector3d> vector; ///< tool axis
  std::optional<Eigen::Vector3d> normal;
  double feed = 0.0;    ///< F as it stands there
  double minutes = 0.0; ///< of a feed move, from its F; 0 if F is a feed a minute and X Y Z stand
};

/** A program: its moves and all other lines. */
struct ParsedProgram {
  std::vector<ParsedMove> moves;
  std::vector<std::string> others;
  std::vector<std::size_t> moves_before; ///< for each other line

  bool has(const std::string& line) const;
  void addOther(const std::string& line);
  /** Number of moves before each line equal to \p line. */
  std::vector<std::size_t> placesOf(const std::string& line) const;
};

ParsedProgram parseFanuc(const std::string& file); ///< also reads LinuxCNC programs
ParsedProgram parseSiemens(const std::string& file);
ParsedProgram parseHeidenhain(const std::string& file);

/** One GOTO of a CLDATA file with the FEDRAT and the RAPID before it. */
struct AptMove {
  Eigen::Vector3d tip, axis;
  double feed;
  bool rapid;
};

/** Locations of an APT file; other statements go to \p others. */
std::vector<AptMove> parseAPT(const std::string& file, std::vector<std::string>& others);

} // namespace pcl_spiral::test
