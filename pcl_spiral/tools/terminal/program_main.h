// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Start and end of a program.
 */
#pragma once

#include <functional>
#include <string>

/** Runs \p body, which returns the program's exit code, and reports errors on stderr. The program first starts itself again, with \p argv,
 *  threads that sleep while they wait, and large pages of memory, unless OMP_WAIT_POLICY or GOMP_SPINCOUNT, and glibc.malloc.hugetlb in
 *  GLIBC_TUNABLES, are set. \return that code; 1 if data or a file failed, 2 for a wrong command line */
int runProgram(const std::string& name, char* const* argv, const std::function<int()>& body);
