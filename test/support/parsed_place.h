// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of the tool at the moves of a program that was read back.
 */
#pragma once

#include "support/program_parsers.h"
#include "support/test_machines.h"

#include <pcl_spiral/io/program_writer.h>

namespace pcl_spiral::test {

inline ParsedProgram
parsed(const std::string& file, Dialect dialect)
{
  return dialect == Dialect::Siemens ? parseSiemens(file) : dialect == Dialect::Heidenhain ? parseHeidenhain(file) : parseFanuc(file);
}

/** Tip and tool axis of a move: from the move itself, or from its angles by the chain of the oracle. */
inline TipAndAxis
where(const Machine& machine, const ParsedMove& move)
{
  if (move.vector)
    return {move.xyz, move.vector->normalized()};
  const auto& rotary = machine.rotary;
  TipAndAxis found = forward(chainOf(machine), {move.xyz, move.degrees.at(rotary[0].letter), move.degrees.at(rotary[1].letter)});
  if (machine.rtcp)
    found.tip = move.xyz;
  return found;
}

} // namespace pcl_spiral::test
