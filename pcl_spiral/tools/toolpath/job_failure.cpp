// SPDX-License-Identifier: BSD-3-Clause
#include "job_failure.h"

#include "terminal/setter_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>

#include <utility>

using namespace pcl_spiral;

namespace {

/** Turns a message about a cloud of samples into one about the mesh. */
std::string
inMesh(std::string message)
{
  constexpr std::pair<const char*, const char*> words[] = {
      {"is below the noise of the scan,", "is below what local fits to the samples of the mesh leave,"},
      {" (standard deviation of a point)", " (standard deviation)"},
      {", and cannot show lengths below three times that: this scan cannot show whether it was kept",
       "; it cannot show lengths below three times that. Sample it more closely (--sample-spacing)"},
      {"; if it is a real hole, the path still runs over it", ": it is narrower than the holes asked for (--hole-size)"},
      {"a gap in the scan", "a hole of the mesh"},
      {"gaps of the scan", "holes of the mesh"},
      {"scan it again, more densely", "sample it more closely (--sample-spacing)"},
      {"scan more densely", "sample it more closely (--sample-spacing)"},
      {"scan it again", "close it in the mesh"},
      {"the whole scan", "the whole mesh"},
      {"fits everywhere on the scan",
       "fits everywhere on the mesh; if that place is only roughness of the mesh, increase the sample spacing (--sample-spacing)"},
      {"scanned surface", "surface"},
      {"the scan", "the mesh"},
      {"the cloud", "the mesh"}};
  for (const auto& [scan, mesh] : words)
    for (std::size_t at = message.find(scan); at != std::string::npos; at = message.find(scan, at + std::string(mesh).size()))
      message.replace(at, std::string(scan).size(), mesh);
  return message;
}

} // namespace

std::string
inWords(const Job& job, const std::string& message)
{
  return inOptions(job.mesh ? inMesh(message) : message);
}

void
requireOk(const Job& job, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(job.scan + ": " + inWords(job, status.message()));
  if (!status.ok())
    throw FileError(job.scan, inWords(job, status.message()));
}
