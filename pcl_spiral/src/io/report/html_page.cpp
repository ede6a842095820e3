// SPDX-License-Identifier: BSD-3-Clause
#include "html_page.h"

#include "embedded_texts.h"
#include "io/base64_text.h"
#include "io/byte_file.h"

#include "common/readable_text.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

/** The page asks for nothing outside. */
const char* const policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

const char* const style = R"(
body { font: 15px/1.45 "Liberation Sans", Arial, Helvetica, sans-serif; color: #21262e; background: #fff;
       max-width: 1060px; margin: 0 auto; padding: 24px; }
h1 { font-size: 27px; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 22px; margin: 36px 0 8px; border-bottom: 2px solid #21262e; overflow-wrap: anywhere; }
h3 { font-size: 17px; margin: 26px 0 8px; }
p { margin: 6px 0; }
.subtitle, .foot { color: #565e6b; }
.statement { border-left: 8px solid #8a93a1; background: #f2f4f6; padding: 10px 14px; margin: 16px 0; }
.statement b { font-size: 17px; }
.good { border-color: #1d8a4b; background: #e9f6ee; }
.unproven { border-color: #c98a00; background: #fff6df; }
.bad { border-color: #c4121f; background: #fdecec; }
ul { margin: 6px 0; padding-left: 22px; }
li { overflow-wrap: anywhere; }
table { border-collapse: collapse; margin: 8px 0; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: 3px 16px 3px 0; border-bottom: 1px solid #d5d9df;
         overflow-wrap: anywhere; }
th { border-bottom: 1.5px solid #21262e; }
td:first-child { width: 38%; }
figure { margin: 18px 0 26px; }
img { width: 100%; height: auto; border: 1px solid #d5d9df; display: block; }
figcaption { margin-top: 5px; color: #565e6b; }
pre { background: #f2f4f6; padding: 10px 14px; white-space: pre-wrap; overflow-wrap: anywhere; }
@page { margin: 14mm; }
@media print {
  body { font-size: 10.5pt; max-width: none; padding: 0; }
  figure, tr, .statement { break-inside: avoid; }
  h2, h3, thead { break-after: avoid; }
  * { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)";

std::string
element(const char* name, const std::string& text)
{
  return std::string("<") + name + ">" + escaped(text) + "</" + name + ">\n";
}

} // namespace

HtmlPage::HtmlPage(const std::string& title, const std::string& subtitle)
: body_("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width\"/>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
        std::string(policy) + "\"/>\n" + element("title", title) + "<style>" + style + scene_style + "</style>\n</head>\n<body>\n" +
        element("h1", title) + "<p class=\"subtitle\">" + escaped(subtitle) + "</p>\n")
{}

void
HtmlPage::addPart(const std::string& text)
{
  body_ += element("h2", text);
}

void
HtmlPage::addHeading(const std::string& text)
{
  body_ += element("h3", text);
}

void
HtmlPage::addText(const std::string& text)
{
  body_ += element("p", text);
}

void
HtmlPage::addCode(const std::string& text)
{
  body_ += element("pre", text);
}

void
HtmlPage::addStatement(Tone tone, const std::string& statement, const std::vector<std::string>& grounds)
{
  body_ += std::string("<div class=\"statement") +
           (tone == Tone::Good       ? " good"
            : tone == Tone::Unproven ? " unproven"
            : tone == Tone::Bad      ? " bad"
                                     : "") +
           "\">\n" + element("b", statement);
  addList(grounds);
  body_ += "</div>\n";
}

void
HtmlPage::addList(const std::vector<std::string>& items)
{
  if (items.empty())
    return;
  body_ += "<ul>\n";
  for (const std::string& item : items)
    body_ += element("li", item);
  body_ += "</ul>\n";
}

void
HtmlPage::addTable(const HtmlRows& rows, bool head)
{
  std::vector<bool> used;
  for (std::size_t r = head ? 1 : 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      used.resize(std::max(used.size(), c + 1));
      used[c] = used[c] || !rows[r][c].empty();
    }
  body_ += "<table>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const bool is_head = head && r == 0;
    body_ += is_head ? "<thead><tr>" : r == 1 && head ? "<tbody><tr>" : "<tr>";
    for (std::size_t c = 0; c < rows[r].size(); ++c)
      if (c < used.size() && used[c])
        body_ += (is_head ? "<th>" : "<td>") + escaped(rows[r][c]) + (is_head ? "</th>" : "</td>");
    body_ += is_head ? "</tr></thead>\n" : "</tr>\n";
  }
  body_ += head && rows.size() > 1 ? "</tbody></table>\n" : "</table>\n";
}

void
HtmlPage::addMarkup(const std::string& markup)
{
  body_ += markup;
}

void
HtmlPage::addPicture(const ReportPicture& picture)
{
  const std::string png = readBytes(picture.file);
  body_ += "<figure><img alt=\"" + escaped(picture.caption) + "\" src=\"data:image/png;base64," + base64(png.data(), png.size()) + "\"/>" +
           element("figcaption", picture.caption) + "</figure>\n";
}

void
HtmlPage::write(const std::string& file, const ReportPage& page)
{
  if (!page.command.empty()) {
    addHeading("Made by");
    addCode(page.command);
  }
  ByteFile out(file);
  out.write(body_);
  out.write("<p class=\"foot\">" + escaped(page.made) + "</p>\n</body>\n</html>\n");
  out.close();
}

std::string
escaped(const std::string& text)
{
  std::string result;
  for (const char c : readableText(text))
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  return result;
}

} // namespace pcl_spiral
