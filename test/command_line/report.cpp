// SPDX-License-Identifier: BSD-3-Clause
// Reports in HTML from outside: one file that needs no other, its pictures, figures, verdict and refusals.
#include "cap_scan.h"
#include "run_program.h"

#include "support/base64_bytes.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <cstdlib>
#include <set>
#include <sstream>

namespace report_test {

namespace {

using pcl_spiral::test::decoded;
using Arguments = std::vector<std::string>;
using Tree = boost::property_tree::ptree;

const std::string awkward = "ca<p> & \"1\" 'x'"; // a name with special characters of HTML

/** The parts of a report. */
struct Page {
  std::string text;             ///< all words, a line a piece
  std::vector<std::string> png; ///< bytes of its pictures
  Arguments statements;         ///< classes of its boxes
};

void
collect(const Tree& tree, Page& page)
{
  for (const auto& [name, child] : tree) {
    if (name == "<xmlattr>") {
      if (const auto source = child.get_optional<std::string>("src")) { // no script has one
        const std::string head = "data:image/png;base64,";
        EXPECT_EQ(source->rfind(head, 0), 0U) << source->substr(0, 80);
        page.png.push_back(decoded(source->substr(head.size())));
      }
      EXPECT_FALSE(child.get_optional<std::string>("href"));
      EXPECT_FALSE(child.get_optional<std::string>("srcset"));
      const std::string type = child.get("class", "");
      if (type.rfind("statement", 0) == 0)
        page.statements.push_back(type);
      continue;
    }
    if (name == "script")
      continue;
    if (name != "style" && name != "<xmlcomment>")
      page.text += child.data() + "\n";
    EXPECT_NE(name, "link");
    collect(child, page);
  }
}

/** \p html without the contents of its scripts, of which report_scene.cpp looks what they ask for. */
std::string
withoutScripts(std::string html)
{
  for (std::size_t at = html.find("<script"); at != std::string::npos; at = html.find("<script", at + 1)) {
    const std::size_t begin = html.find('>', at) + 1;
    html.erase(begin, html.find("</script>", begin) - begin);
  }
  return html;
}

Page
readPage(const std::string& file)
{
  const std::string html = readText(file), plain = withoutScripts(html);
  for (const char* link : {"http:", "https:", "url(", "@import"})
    EXPECT_EQ(plain.find(link), std::string::npos) << "nothing to download";
  std::istringstream in(html);
  Tree tree;
  boost::property_tree::read_xml(in, tree); // throws if it is not well-formed
  Page page;
  collect(tree, page);
  return page;
}

class Report : public ::testing::Test {
protected:
  void SetUp() override
  {
    std::filesystem::create_directory(folder_.path("tmp"));
    ::setenv("TMPDIR", folder_.path("tmp").c_str(), 1);
    writeText(folder_.path(awkward + ".xyz"), capScan(6000));
  }
  void TearDown() override
  {
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path("tmp"))) << "pictures left behind";
    ::unsetenv("TMPDIR");
  }

  RunResult run(const char* program, const Arguments& arguments) { return endOf(startProgram(program, arguments, folder_), folder_); }

  RunResult make(Arguments arguments)
  {
    arguments.insert(arguments.begin(), {awkward + ".xyz", "--tool-radius", "3", "--scallop", "0.1"});
    return run(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments);
  }

  RunResult verify(Arguments arguments)
  {
    arguments.insert(arguments.begin(), {awkward + ".xyz"});
    arguments.insert(arguments.end(), {"--tool-radius", "3", "--scallop", "0.1"});
    return run(PCL_SPIRAL_VERIFY_PROGRAM, arguments);
  }

  /** The PNG must be of full size and show something. */
  void expectPicture(const std::string& bytes)
  {
    writeText(folder_.path("shown.png"), bytes);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(folder_.path("shown.png").c_str());
    reader->Update();
    vtkImageData* const image = reader->GetOutput();
    ASSERT_EQ(image->GetDimensions()[0], 1600);
    ASSERT_EQ(image->GetDimensions()[1], 1200);
    std::set<std::array<unsigned char, 3>> colours;
    for (int y = 0; y < 1200; y += 3)
      for (int x = 0; x < 1600; x += 3) {
        const auto* const pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
        colours.insert({pixel[0], pixel[1], pixel[2]});
      }
    EXPECT_GT(colours.size(), 20U) << "a blank picture";
  }

  ScratchFolder folder_;
};

TEST_F(Report, HoldsPicturesFiguresAndSettings)
{
  const RunResult result = make({"--verify", "-o", "a.html", "-o", "a.png", "-o", "a.json", "-o", "a.csv"});
  ASSERT_EQ(result.code, 0) << result.err;
  const Page page = readPage(folder_.path("a.html"));
  const std::vector<std::string> pictures{"a_deviation.png", "a_stock.png", "a_histogram.png", "a.png", "a_lines.png"};
  ASSERT_EQ(page.png.size(), pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_TRUE(page.png[i] == readText(folder_.path(pictures[i]))) << pictures[i];
    expectPicture(page.png[i]);
    EXPECT_NE(result.out.find(pictures[i]), std::string::npos) << result.out;
  }
  EXPECT_EQ(std::set<std::string>(page.png.begin(), page.png.end()).size(), pictures.size()) << "all different";

  const auto json = nlohmann::json::parse(readText(folder_.path("a.json")));
  const auto& judged = json.at("verification");
  const auto number = [](const char* format, const nlohmann::json& value) {
    char text[80];
    std::snprintf(text, sizeof(text), format, value.get<double>());
    return std::string(text);
  };
  const auto& at = judged.at("deviation").at("max").at("position");
  for (const std::string& words :
       {awkward + ".xyz", number("%+.4f mm\n", judged.at("deviation").at("max").at("value")),
        number("\n%.3f, ", at[0]) + number("%.3f, ", at[1]) + number("%.3f\n", at[2]),
        number("\n%.4f mm\n", judged.at("material").at("scallop").at("p99.9")), number("\n%.3f\n", judged.at("material").at("efficiency")),
        number("%.3f m\n", 1e-3 * json["path"]["length"].get<double>()), std::string("Longest linear move"),
        std::string("Largest turn per step"), std::string("\n0.1 mm\n"), std::string("Method\nconstant-scallop\n"),
        std::string("no limits were stated"), std::string("pcl_spiral_toolpath 'ca<p> & \"1\" '\\''x'\\''.xyz'")})
    EXPECT_NE(page.text.find(words), std::string::npos) << words << "\nin\n" << page.text;
  for (const auto& warning : json.at("warnings"))
    EXPECT_NE(page.text.find(warning.get<std::string>()), std::string::npos) << warning;
}

TEST_F(Report, OfAPathThatIsNotJudgedSaysSoWhateverItsName)
{
  const std::string name = "sc\xFF\xC3\x01n.xyz"; // bytes that are not text
  writeText(folder_.path(name), capScan(3000));
  ASSERT_EQ(run(PCL_SPIRAL_TOOLPATH_PROGRAM, {name, "--tool-radius", "3", "--scallop", "0.2", "-o", "a.html"}).code, 0);
  const std::string html = readText(folder_.path("a.html"));
  EXPECT_EQ(html.find('\xFF'), std::string::npos);
  EXPECT_EQ(html.find('\x01'), std::string::npos);
  const Page page = readPage(folder_.path("a.html"));
  EXPECT_NE(page.text.find("sc\uFFFD\uFFFD\uFFFDn.xyz"), std::string::npos);
  EXPECT_EQ(page.png.size(), 2U);
  EXPECT_NE(page.text.find("Not judged"), std::string::npos);
  EXPECT_EQ(page.statements, Arguments{"statement"});
}

TEST_F(Report, OfSeveralPathsSaysWhichKeepsTheLimits)
{
  ASSERT_EQ(make({"-o", "good.csv"}).code, 0);
  std::istringstream rows(readText(folder_.path("good.csv")));
  std::string spoilt, row;
  for (int i = 0; std::getline(rows, row); ++i) // only the innermost turns
    if (i < 400)
      spoilt += row + "\n";
  writeText(folder_.path("bad.csv"), spoilt);

  const RunResult result = verify({"bad.csv", "good.csv", "-o", "both.html", "--max-uncut", "0", "--max-gouge", "0.05"});
  EXPECT_EQ(result.code, 1) << result.err;
  const Page page = readPage(folder_.path("both.html"));
  EXPECT_EQ(page.statements, (Arguments{"statement bad", "statement good"})) << result.out;
  ASSERT_EQ(page.png.size(), 8U);
  EXPECT_EQ(std::set<std::string>(page.png.begin(), page.png.end()).size(), 8U) << "each path has its own";
  for (const char* words : {"Limits are broken", "All stated limits hold", "0 %, BROKEN", "0.05 mm, held", "\ngood.csv\n"})
    EXPECT_NE(page.text.find(words), std::string::npos) << words;
}

TEST_F(Report, IsRefusedWithoutADisplayOrAPlace)
{
  ASSERT_EQ(make({"-o", "a.csv"}).code, 0);
  const std::size_t before = folder_.count();
  const auto refused = [&](const RunResult& result, const std::vector<std::string>& words) {
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out, "");
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
    EXPECT_EQ(folder_.count(), before) << "left a file behind";
  };
  refused(make({"-o", "b.csv", "-o", "nowhere/a.html"}), {"nowhere/a.html", "create it"});
  refused(verify({"a.csv", "-o", "nowhere/a.html"}), {"nowhere/a.html", "create it"});
  ::setenv("TMPDIR", folder_.path("nowhere").c_str(), 1);
  refused(make({"-o", "b.csv", "-o", "b.html"}), {"TMPDIR"});
  ::setenv("TMPDIR", folder_.path("tmp").c_str(), 1);
  const std::string display = ::getenv("DISPLAY") ? ::getenv("DISPLAY") : "";
  ::unsetenv("DISPLAY");
  refused(make({"-o", "b.csv", "-o", "b.html"}), {"b.html", "display", "xvfb-run -a"});
  for (const char* output : {"b.html", "b.png"})
    refused(verify({"a.csv", "-o", "b.json", "-o", output}), {output, "display", "xvfb-run -a"});
  display.empty() ? ::unsetenv("DISPLAY") : ::setenv("DISPLAY", display.c_str(), 1);
}

} // namespace

} // namespace report_test
