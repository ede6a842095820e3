// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The figures of a path on an HTML page. Private to io.
 */
#pragma once

#include "html_page.h"
#include <pcl_spiral/io/verification_writer.h>

namespace pcl_spiral {

/** Limits held or broken, of \p name; empty: it is the only path. */
void addVerdict(HtmlPage& page, const VerificationRun& run, const Verification& verification, const std::string& name);

/** Figures, and what the scan can show of them; no warnings. */
void addFigures(HtmlPage& page, const VerificationRun& run, const Verification& verification);

/** How long the steps of judging took: rows of name and seconds. */
HtmlRows judgingTimes(const Verification& verification);

/** Warnings under a heading of their own; "None." if there are none. */
void addWarnings(HtmlPage& page, const std::vector<std::string>& warnings);

} // namespace pcl_spiral
