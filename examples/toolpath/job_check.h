/** \file
 *  What is wrong with a job before any work starts.
 */
#pragma once

#include "job.h"

/** \throw UsageError for a setting that is missing, out of range or contradicts another */
void checkJob(const Job& job);

/** Every file the job makes: the outputs, and beside each picture NAME.png its NAME_lines.png. */
std::vector<std::string> filesOf(const Job& job);

/** .csv of part.CSV */
std::string extensionOf(const std::string& file);

/** part_lines.png of part.png */
std::string linesPicture(const std::string& picture);
