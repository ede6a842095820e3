// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A page for people as one HTML file that needs no other. Private to io.
 */
#pragma once

#include "report_page.h"

#include <string>
#include <vector>

namespace pcl_spiral {

/** How good a statement is. */
enum class Tone { Neutral, Good, Doubtful, Bad };

/** Cells of a table, row by row. A first row of the same length is the head. */
using HtmlRows = std::vector<std::vector<std::string>>;

/** A page written from top to bottom. Every word given to it is escaped; the result is also well-formed XML.
 */
class HtmlPage {
public:
  /** \p subtitle stands below the title. */
  HtmlPage(const std::string& title, const std::string& subtitle);

  void addHeading(const std::string& text);
  /** Broad sections, of which there are several with headings of their own. */
  void addPart(const std::string& text);
  void addText(const std::string& text);
  void addCode(const std::string& text);
  /** A coloured box: a statement and what it rests on. */
  void addStatement(Tone tone, const std::string& statement, const std::vector<std::string>& grounds);
  void addList(const std::vector<std::string>& items);
  /** With a head: its first row. Columns without any word are left out. */
  void addTable(const HtmlRows& rows, bool head);
  /** \throw FileError where the picture cannot be read */
  void addPicture(const ReportPicture& picture);

  /** \throw FileError */
  void write(const std::string& file, const std::string& foot);

private:
  std::string body_;
};

/** \p text with XML's own characters written as entities, and what is no character of XML as U+FFFD. */
std::string escaped(const std::string& text);

/** Numbers in words, by a format of printf. */
std::string words(const char* format, ...) __attribute__((format(printf, 1, 2)));

} // namespace pcl_spiral
