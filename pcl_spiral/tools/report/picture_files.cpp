// SPDX-License-Identifier: BSD-3-Clause
#include "picture_files.h"

#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

using namespace pcl_spiral;
namespace fs = std::filesystem;

namespace {

const char*
captionOf(PictureKind kind)
{
  switch (kind) {
  case PictureKind::Spiral:
    return "Toolpath on the shaded surface; start and end enlarged, with every turn.";
  case PictureKind::Lines:
    return "Boundaries and the lines of the path on the scan.";
  case PictureKind::Passes:
    return "Passes on the shaded part, coloured by their numbers; start and end enlarged.";
  case PictureKind::Deviation:
    return "Deviation of the contacts from the scanned surface, mm; + is out of the material; the worst place "
           "enlarged.";
  case PictureKind::Stock:
    return "Stock left on the surface after the cut, mm; the worst place enlarged.";
  case PictureKind::Histogram:
    return "Scallop histogram: ridge heights between passes, mm.";
  case PictureKind::Rotary:
    return "Rotary axes, and speed of the contact, along the program.";
  case PictureKind::Reach:
    return "Radius of the largest ball that reaches each point, mm; the tightest place enlarged.";
  }
  return "";
}

std::string
makeFolder()
{
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "pcl_spiral-XXXXXX").string();
  if (error || !::mkdtemp(name.data()))
    throw FileError(name,
                    Diagnostic("the temporary folder for pictures cannot be made: ",
                               (error ? error.message() : std::string(std::strerror(errno))), "; set TMPDIR to a folder you may write to"));
  return name;
}

} // namespace

PictureFiles::~PictureFiles()
{
  std::error_code ignored;
  if (!folder_.empty())
    fs::remove_all(folder_, ignored);
}

std::string
PictureFiles::add(PictureKind kind)
{
  if (cancelled())
    throw Cancelled();
  if (folder_.empty())
    folder_ = makeFolder();
  files_.push_back({kind, folder_ + "/" + std::to_string(files_.size()) + ".png"});
  return files_.back().file;
}

void
PictureFiles::drawPath(const PictureScene& scene, bool lines)
{
  const SpiralPictures pictures(scene);
  pictures.writeSpiral(add(PictureKind::Spiral));
  if (lines)
    pictures.writeLines(add(PictureKind::Lines));
}

void
PictureFiles::drawPasses(const PassScene& scene)
{
  writePasses(add(PictureKind::Passes), scene);
}

void
PictureFiles::drawReach(const ReachScene& scene)
{
  writeReach(add(PictureKind::Reach), scene);
}

void
PictureFiles::drawProgram(const std::string& title, const MachineProgram& program)
{
  writeRotaryAngles(add(PictureKind::Rotary), title, program);
}

void
PictureFiles::drawJudging(const VerificationScene& scene)
{
  const VerificationPictures pictures(scene);
  pictures.writeDeviation(add(PictureKind::Deviation));
  pictures.writeStock(add(PictureKind::Stock));
  pictures.writeHistogram(add(PictureKind::Histogram));
}

const PictureFile*
PictureFiles::find(PictureKind kind) const
{
  const auto last = std::find_if(files_.rbegin(), files_.rend(), [kind](const auto& f) { return f.kind == kind; });
  return last == files_.rend() ? nullptr : &*last;
}

void
PictureFiles::copy(PictureKind kind, const std::string& file) const
{
  const PictureFile* const picture = find(kind);
  if (!picture)
    throw std::logic_error(file + ": its picture has not been drawn");
  std::error_code error;
  fs::copy_file(picture->file, file, fs::copy_options::overwrite_existing, error);
  if (error)
    throw FileError(file, Diagnostic("cannot be written: ", error.message()));
}

std::vector<ReportPicture>
PictureFiles::forReport(const std::vector<PictureKind>& kinds) const
{
  std::vector<ReportPicture> pictures;
  for (const PictureKind kind : kinds)
    if (const PictureFile* const picture = find(kind))
      pictures.push_back({picture->file, captionOf(kind)});
  return pictures;
}

void
requireDisplay(const std::string& output)
{
  const std::string extension = extensionOf(output);
  if (extension != ".png" && extension != ".html")
    return;
  const std::string problem = displayProblem();
  if (problem.empty())
    return;
  throw FileError(output, extension == ".png" ? Diagnostic(problem)
                                              : Diagnostic("this report needs pictures: ", problem, "; .json has the same figures"));
}
