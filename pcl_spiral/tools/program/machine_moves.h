// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From tool poses to the moves of a machine.
 */
#pragma once

#include "program_job.h"

#include <string>
#include <vector>

/** The machine of a job that has a program. \throw pcl_spiral::FileError */
pcl_spiral::Machine machineOf(const ProgramJob& program);

/** Lays the passes on \p machine; what a user should know of it goes to \p warnings. \p ball_radius: 0 for other
 *  cutters. \throw pcl_spiral::FileError where the machine cannot make it */
pcl_spiral::MachineProgram makeProgram(const ProgramJob& job, const pcl_spiral::Machine& machine, double feed, double ball_radius,
                                       const std::vector<pcl_spiral::ToolPoses>& passes, std::vector<std::string>& warnings);

/** What the program came to, for people. */
void printProgram(const pcl_spiral::MachineProgram& program);
