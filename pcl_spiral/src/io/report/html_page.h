// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A readable page as one HTML file that needs no other file. Private to io.
 */
#pragma once

#include <pcl_spiral/io/report_page.h>

#include "common/formatted_text.h"

#include <string>
#include <vector>

namespace pcl_spiral {

/** Rating of a statement. */
enum class Tone { Neutral, Good, Unproven, Bad };

/** Cells of a table, row by row. The first row is the head if it has the same length. */
using HtmlRows = std::vector<std::vector<std::string>>;

/** A page written from top to bottom. All given text is escaped; the result is also well-formed XML.
 */
class HtmlPage {
public:
  /** \p subtitle is below the title. */
  HtmlPage(const std::string& title, const std::string& subtitle);

  void addHeading(const std::string& text);
  /** A main section, which has several parts with headings. */
  void addPart(const std::string& text);
  void addText(const std::string& text);
  void addCode(const std::string& text);
  /** A coloured box: a statement and its reasons. */
  void addStatement(Tone tone, const std::string& statement, const std::vector<std::string>& grounds);
  void addList(const std::vector<std::string>& items);
  /** With a head: its first row. Columns without text are left out. */
  void addTable(const HtmlRows& rows, bool head);
  /** Parts of a page that are HTML and XML already. */
  void addMarkup(const std::string& markup);
  /** \throw FileError if the picture cannot be read */
  void addPicture(const ReportPicture& picture);

  /** Ends the page with the command, if there is one, and the foot of \p page. \throw FileError */
  void write(const std::string& file, const ReportPage& page);

private:
  std::string body_;
};

/** \p text with the special characters of XML as entities, and characters that XML does not allow as U+FFFD. */
std::string escaped(const std::string& text);

} // namespace pcl_spiral
