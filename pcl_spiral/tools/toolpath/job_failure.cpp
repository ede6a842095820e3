// SPDX-License-Identifier: BSD-3-Clause
#include "job_failure.h"

#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>

using namespace pcl_spiral;

void
requireOk(const Job& job, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(Diagnostic(job.scan, ": ", status.diagnostic()));
  if (!status.ok())
    throw FileError(job.scan, status.diagnostic());
}
