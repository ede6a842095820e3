// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The figures of a path in the terminal.
 */
#pragma once

#include <pcl_spiral/verify/verification.h>

/** Figures with their places, then the limits that are broken or not shown to hold. */
void printFigures(const pcl_spiral::Verification& verification);
