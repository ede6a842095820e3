/** \file
 *  Options for the program of a machine.
 */
#pragma once

#include "option_table.h"

OptionGroup programOptions();
