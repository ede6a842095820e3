// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes a path from a scan or mesh file.
 */
#pragma once

#include "outputs.h"

/** Reads the scan or the mesh, and plans the path. \throw as require in terminal/failure.h */
Result plan(const Job& job);
