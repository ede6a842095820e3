// SPDX-License-Identifier: BSD-3-Clause
#include "program_main.h"

#include "scan_places.h"
#include "setter_names.h"
#include "terminal.h"

#include <iostream>

int
runProgram(const std::string& name, const std::function<int()>& body)
{
  constexpr int failed_on_data = 1, bad_usage = 2;
  catchSignals();
  try {
    return body();
  }
  catch (const UsageError& error) {
    std::cerr << name << ": " << inScan(error.what()) << '\n' << name << " --help lists the options\n";
    return bad_usage;
  }
  catch (const std::exception& error) {
    std::cerr << name << ": " << inScan(inOptions(error.what())) << '\n';
    return failed_on_data;
  }
}
