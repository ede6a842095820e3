// SPDX-License-Identifier: BSD-3-Clause
#include "scene_html.h"

#include "scene_json.h"

namespace pcl_spiral {
namespace {

/** A script of a page that is XML, too. */
std::string
scriptElement(const char* text)
{
  return std::string("<script>//<![CDATA[\n") + text + "\n//]]></script>\n";
}

} // namespace

void
addScene(const ReportScene* scene, HtmlPage& page, const char* three)
{
  if (!scene || scene->frames.empty())
    return;
  if (*three == '\0') {
    page.addText("This report has pictures alone: the program was built without three.js (Debian's package libjs-three).");
    return;
  }
  for (const std::string& note : scene->notes)
    page.addText(note);
  page.addMarkup(scene_markup);
  page.addMarkup("<script type=\"application/json\" id=\"scene-data\">" + sceneJson(*scene) + "</script>\n");
  page.addMarkup(std::string("<!--\n") + three_licence + "-->\n");
  page.addMarkup(scriptElement(three));
  page.addMarkup(scriptElement(scene_script));
}

} // namespace pcl_spiral
