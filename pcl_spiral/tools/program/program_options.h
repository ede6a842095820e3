// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options for the machine program.
 */
#pragma once

#include "program_job.h"
#include "terminal/option_table.h"

OptionGroup programOptions(ProgramJob& program);
