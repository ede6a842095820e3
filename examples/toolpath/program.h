/** \file
 *  From a path to the program of a machine.
 */
#pragma once

#include "outputs.h"

/** Whether an output is a program, by its extension: .ngc .nc */
bool isProgram(const std::string& output);
/** .apt .cls .yaml */
bool isExchange(const std::string& output);
/** Whether the job makes a program, to write or to draw. */
bool hasProgram(const Job& job);

/** \throw UsageError for a setting that is missing, out of range or contradicts another */
void checkProgram(const Job& job);

/** The machine of a job that has a program. \throw pcl_spiral::FileError */
pcl_spiral::Machine machineOf(const Job& job);

/** Lays the path on \p machine; what a user should know of it goes to the report's warnings. \throw
 * pcl_spiral::FileError where the machine cannot make it */
void makeProgram(const Job& job, const pcl_spiral::Machine& machine, Result& result);

/** One output of the kinds above, into \p file. \throw pcl_spiral::FileError */
void writeMoves(const Job& job, const Result& result, const std::string& output, const std::string& file);

/** What the program came to, for people. */
void printProgram(const pcl_spiral::MachineProgram& program);
