// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The surface of the scan, made before there is a path of contacts.
 */
#pragma once

#include "judging/judged_part.h"
#include "verify_job.h"

#include <pcl_spiral/verify/impl/reference_surface.h>

#include <memory>

/** \throw pcl_spiral::FileError, Cancelled */
std::shared_ptr<const pcl_spiral::ReferenceSurface> scanReference(const VerifyJob& job, const JudgedPart& part);
