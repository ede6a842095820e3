/* SPDX-License-Identifier: BSD-3-Clause */
/** \file
 *  The calls of LinuxCNC's trajectory planner that the tests need, in plain C.
 */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

struct linuxcnc_planner;

/** Limits of X Y Z A B C: mm/s, degrees/s, and the same per s. */
struct linuxcnc_setup {
  double cycle; ///< s
  double velocity[6];
  double acceleration[6];
  double largest_velocity; ///< of any move
  double largest_acceleration;
};

/** One move as the planner takes it. */
struct linuxcnc_line {
  int id;
  int rapid;
  double to[6];            ///< mm and degrees
  double velocity;         ///< asked for, mm/s or degrees/s
  double largest_velocity; ///< that the axes allow
  double acceleration;     ///< that the axes allow
  double tolerance;        ///< of the blend at its end, mm; 0: none
};

/** Whether the headers of the package were there when the tests were built. */
int linuxcnc_planner_built(void);
/** The planner of \p module, the file of tpmod; null if it cannot be loaded. One at a time. */
struct linuxcnc_planner* linuxcnc_planner_new(const char* module, const struct linuxcnc_setup* setup, const double* start);
void linuxcnc_planner_delete(struct linuxcnc_planner* planner);
/** Adds a move; below 0: refused. */
int linuxcnc_planner_add(struct linuxcnc_planner* planner, const struct linuxcnc_line* line);
int linuxcnc_planner_queued(struct linuxcnc_planner* planner);
/** Runs a cycle. \p place: where the axes are then. The id of the running move; -1: all is done. */
int linuxcnc_planner_cycle(struct linuxcnc_planner* planner, double* place);

#ifdef __cplusplus
}
#endif
