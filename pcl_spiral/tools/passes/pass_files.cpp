// SPDX-License-Identifier: BSD-3-Clause
#include "pass_files.h"

#include "program/exchange_files.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** The cutter of a job in CLDATA; nothing for a beam, which only robot frames take. */
AptCutter
exchangeCutter(const PassJob& job)
{
  return job.cutter.radius > 0.0 ? aptCutter(CutterProfile(job.cutter)) : AptCutter();
}

} // namespace

bool
isPassFile(const std::string& output)
{
  const std::string extension = extensionOf(output);
  const auto& known = toolpathExtensions();
  return isProgram(output) || isExchange(output) || extension == ".6d" || extension == ".5d" || extension == ".json" ||
         extension == ".png" || std::find(known.begin(), known.end(), extension) != known.end();
}

void
writePassFile(const PassJob& job, const PassResult& result, const std::string& title, const std::string& output, const std::string& file)
{
  const std::string extension = extensionOf(output);
  if (isProgram(output))
    return writeProgramFile(job.program, *result.program, programTexts(job, job.feed, title), output, file);
  if (extension == ".6d")
    return writePoseVectors(file, result.passes);
  if (extension == ".5d")
    return writePoseAngles(file, result.passes);
  if (isExchange(output))
    return writeExchange(job.program, {title, exchangeCutter(job), result.moves}, result.program, output, file);
  const PassPath all = joinedPasses(result.passes);
  writeToolpath(file, all.path, {job.cutter.radius, job.feed, all.tips, all.begins, scanShift()});
}

void
writeAll(const PassJob& job, OutputFiles& files, const std::function<void(const std::string& output, std::size_t& next)>& write)
try {
  std::size_t next = 0;
  for (const std::string& output : job.outputs) {
    if (cancelled())
      throw Cancelled();
    write(output, next);
  }
  if (cancelled())
    throw Cancelled();
  files.commit();
}
catch (const FileError& error) {
  throw FileError(Diagnostic(files.asGiven(error.diagnostic()), "; no output has been changed"));
}
