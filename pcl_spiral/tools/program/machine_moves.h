// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Turns tool poses into machine moves.
 */
#pragma once

#include "program_job.h"

#include "io/post/plan_program.h"

#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/planning/program_planner.h>

#include <optional>
#include <string>
#include <vector>

/** The machine of a job, if one of the \p outputs needs it. \throw pcl_spiral::FileError, also if it cannot run the language of one */
std::optional<pcl_spiral::Machine> machineOf(const ProgramJob& program, const std::vector<std::string>& outputs);

/** The program of \p planner on \p machine, with its warnings. \p file is for messages about the part. \throw pcl_spiral::FileError if the
 *  machine cannot make the moves, or if the tool would touch the scan; Cancelled */
pcl_spiral::MachineProgram plannedProgram(const ProgramJob& job, const pcl_spiral::Machine& machine, const std::string& file, bool quiet,
                                          pcl_spiral::ProgramPlanner& planner, pcl_spiral::Diagnostics& warnings);

/** The moves of \p planner with leads, for CLDATA and robot frames. \throw as plannedProgram */
std::vector<pcl_spiral::ToolMoves> plannedMoves(const std::string& file, bool quiet, pcl_spiral::ProgramPlanner& planner,
                                                pcl_spiral::Diagnostics& warnings);

/** The links between the passes of \p planner. \throw as plannedProgram */
pcl_spiral::PassLinks plannedLinks(const std::string& file, bool quiet, pcl_spiral::ProgramPlanner& planner,
                                   pcl_spiral::Diagnostics& warnings);

/** A warning for each output that is a program and leaves the spindle still: no --spindle, and no line of the machine file starts it. */
pcl_spiral::Diagnostics spindleWarnings(const ProgramJob& job, const pcl_spiral::Machine& machine, const std::vector<std::string>& outputs);

/** Writes \p program for \p output as the file \p file: a .ngc in the language of LinuxCNC, others in that of the job. \throw
 *  pcl_spiral::FileError */
void writeProgramFile(const ProgramJob& job, const pcl_spiral::MachineProgram& program, const pcl_spiral::ProgramTexts& texts,
                      const std::string& output, const std::string& file);

/** The time of \p program on the control of the first program of \p outputs. \p chord_error: of the path, mm. */
pcl_spiral::MotionStudy studiedMotion(const ProgramJob& job, const std::vector<std::string>& outputs, double chord_error,
                                      const pcl_spiral::MachineProgram& program);

/** Leaves out blocks within \p tolerance mm, at least. */
void leaveOutBlocks(double tolerance, pcl_spiral::ProgramSettings& settings);

/** Prints a summary of the program and its time. */
void printProgram(const pcl_spiral::MachineProgram& program, const pcl_spiral::MotionStudy& motion);
