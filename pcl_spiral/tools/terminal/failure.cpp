// SPDX-License-Identifier: BSD-3-Clause
#include "failure.h"

#include "terminal.h"

#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

void
require(const std::string& file, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || (status.ok() && cancelled())) // a refusal is told, also if a search after it was stopped
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(Diagnostic(file, ": ", status.diagnostic()));
  if (!status.ok())
    throw FileError(file, status.diagnostic());
}
