// SPDX-License-Identifier: BSD-3-Clause
// What is said to users keeps its places, numbers and settings apart from its words, and each face shows them in its own way.
#include "core/given_together.h"
#include <pcl_spiral/core/diagnostic.h>

#include <gtest/gtest.h>

namespace diagnostic_test {

using namespace pcl_spiral;

Diagnostic
lowStep()
{
  return Diagnostic("the step-over is ", -1.5, " {mm} at ", Place({12.5, -3.0, 0.1251}), ", axis ", Direction({0.0, 0.0, 1.0}), ", in ",
                    std::string("a{mm}(b.csv"), "; set it above 0 ({setStepOver}), or scan again");
}

TEST(Diagnostic, HasTheTextOfItsPartsInTheWordsOfCpp)
{
  EXPECT_EQ(lowStep().text(), "the step-over is -1.5 mm at (12.5, -3, 0.125), axis (0, 0, 1), in a{mm}(b.csv; set it above 0 "
                              "(setStepOver), or scan again");
  EXPECT_EQ(Diagnostic(0.0123456, " {mm}, ", 9999.4, ", ", 10367.5, ", ", 1234567u, ", ", std::size_t{20000000}, ", ", 'C').text(),
            "0.01235 mm, 9999, 10368, 1234567, 20000000, C");
  EXPECT_EQ(Diagnostic("at ", Place({-0.0001, 100.0, 8.45e5})).text(), "at (0, 100, 845000)");
  EXPECT_EQ(Diagnostic(SixDigits(0.285611), " is more than ", SixDigits(0.28561)).text(), "0.285611 is more than 0.28561");
  EXPECT_TRUE(Diagnostic().empty());
  EXPECT_EQ(Diagnostic().text(), "");
}

TEST(Diagnostic, GivesItsFieldsToScripts)
{
  const Diagnostic d = lowStep();
  EXPECT_EQ(d.id(), "the step-over is {number} {mm} at {place}, axis {direction}, in {name}; set it above 0 ({setStepOver}), or scan "
                    "again");
  ASSERT_EQ(d.places().size(), 1u);
  EXPECT_EQ(d.places()[0], Eigen::Vector3d(12.5, -3.0, 0.1251)); // not rounded as the text is
  ASSERT_EQ(d.directions().size(), 1u);
  EXPECT_EQ(d.directions()[0], Eigen::Vector3d::UnitZ());
  EXPECT_EQ(d.numbers(), std::vector<double>{-1.5});
  EXPECT_EQ(d.names(), std::vector<std::string>{"a{mm}(b.csv"});
  EXPECT_EQ(d.settings(), std::vector<std::string>{"setStepOver"});
  EXPECT_EQ(
      Diagnostic("{Limits::gouge}, {setClusterHandling(ClusterHandling::Ride)}, {PartRegion}, {scan}, {mm}, {scan it again}, "
                 "{ReadOptions::skip_lines}")
          .settings(),
      (std::vector<std::string>{"Limits::gouge", "setClusterHandling(ClusterHandling::Ride)", "PartRegion", "ReadOptions::skip_lines"}));
}

TEST(Diagnostic, AFaceNamesFieldsItsOwnWay)
{
  Vocabulary words;
  words.words = {{"setStepOver", "--step-over"}};
  words.place = [](const Eigen::Vector3d& p) { return "<" + std::to_string(static_cast<int>(p.x())) + ">"; };
  EXPECT_EQ(lowStep().text(words), "the step-over is -1.5 mm at <12>, axis (0, 0, 1), in a{mm}(b.csv; set it above 0 (--step-over), or "
                                   "scan again");
}

TEST(Diagnostic, ARemarkInBracketsThatNamesWhatTheFaceHasNotIsLeftOut)
{
  Vocabulary words;
  words.has_setters = false;
  words.words = {{"setRows", "--rows"}};
  EXPECT_EQ(lowStep().text(words), "the step-over is -1.5 mm at (12.5, -3, 0.125), axis (0, 0, 1), in a{mm}(b.csv; set it above 0, or scan "
                                   "again");
  EXPECT_EQ(Diagnostic("take even rows ({setRows}, {setStepOver}), or ({setRows}) none").text(words), "take even rows, or (--rows) none");
  EXPECT_EQ(Diagnostic("sample it ({setSampleSpacing} ", 0.5, " {mm} (fine) or less): done").text(words), "sample it: done");
  EXPECT_EQ(Diagnostic("thin (to an even (", "{setThinning} ", 2, ") spacing) it").text(words), "thin (to an even spacing) it");
  EXPECT_EQ(Diagnostic("{setStepOver} was called (the {scan})").text(words), "setStepOver was called (the scan)");
}

TEST(Diagnostic, ADoubledBraceIsABrace)
{
  EXPECT_EQ(Diagnostic("give {{coolant: {{through: M88}}}} or {mm}").text(), "give {coolant: {through: M88}} or mm");
  EXPECT_EQ(Diagnostic("give {{coolant: on}} or {mm}").id(), "give {{coolant: on}} or {mm}");
  EXPECT_EQ(Diagnostic("has {", std::string("x"), "}").text(), "has {x}");
  EXPECT_EQ(Diagnostic("has {", std::string("x"), "}").id(), "has {{{name}}}");
}

TEST(Diagnostic, GrowsByOthers)
{
  Diagnostic d = "a {mm}";
  d += Diagnostic(", b at ", Place({1.0, 2.0, 3.0}));
  d += d;
  EXPECT_EQ(d.text(), "a mm, b at (1, 2, 3)a mm, b at (1, 2, 3)");
  EXPECT_EQ(d.places().size(), 2u);
  EXPECT_EQ(Diagnostic("file ", std::string("x.tmp"), " at x.tmp").renamed("x.tmp", "x.csv").text(), "file x.csv at x.tmp");
  const Diagnostic of_rows = lowStep().renamed({{"setStepOver", "RowSettings::step"}, {"a{mm}(b.csv", "x"}});
  EXPECT_EQ(of_rows.settings(), std::vector<std::string>{"RowSettings::step"});
  EXPECT_EQ(of_rows.names(), lowStep().names());
}

TEST(Diagnostic, CarriesTheValuesThatItProposes)
{
  const Diagnostic d("thin to ", Proposed("setThinning", 0.5), " {mm} or less ({setThinning}), keep out ",
                     Proposed("addKeepOut", {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}), ", take the ", Proposed("setMethod", "radial"),
                     " method or the part at ", Proposed("setPartAt", Eigen::Vector3d(7.0, 8.0, 9.0)));
  EXPECT_EQ(d.text(), "thin to 0.5 mm or less (setThinning), keep out from (1, 2, 3) to (4, 5, 6), take the radial method or the part at "
                      "(7, 8, 9)");
  EXPECT_EQ(d.id(),
            "thin to {number} {mm} or less ({setThinning}), keep out from {place} to {place}, take the radial method or the part at "
            "{place}");
  EXPECT_EQ(d.settings(), std::vector<std::string>{"setThinning"});
  EXPECT_EQ(d.numbers(), std::vector<double>{0.5});
  EXPECT_EQ(d.places().size(), 3U);
  EXPECT_TRUE(d.given().empty());
  const std::vector<Proposed> proposed = d.renamed({{"setMethod", "method="}}).proposed();
  ASSERT_EQ(proposed.size(), 4U);
  EXPECT_EQ(proposed[0].setting, "setThinning");
  EXPECT_EQ(std::get<double>(proposed[0].value), 0.5);
  EXPECT_EQ(std::get<Extents>(proposed[1].value).high, Eigen::Vector3d(4.0, 5.0, 6.0));
  EXPECT_EQ(proposed[2].setting, "method=");
  EXPECT_EQ(std::get<std::string>(proposed[2].value), "radial");
  EXPECT_EQ(std::get<Eigen::Vector3d>(proposed[3].value), Eigen::Vector3d(7.0, 8.0, 9.0));
}

TEST(Diagnostic, AFaceWritesASettingWithItsValueAsItTakesIt)
{
  const Diagnostic d("one helps: ", Given("setPartAt", Eigen::Vector3d(7.0, 8.0, 9.0)), " and ", Given("setThinning", 0.5));
  EXPECT_EQ(d.text(), "one helps: setPartAt (7, 8, 9) and setThinning 0.5");
  EXPECT_EQ(d.id(), "one helps: {setPartAt} {place} and {setThinning} {number}");
  EXPECT_EQ(d.settings(), (std::vector<std::string>{"setPartAt", "setThinning"}));
  EXPECT_TRUE(d.proposed().empty());
  EXPECT_EQ(d.given().size(), 2U);
  Vocabulary words;
  words.words = {{"setPartAt", "--part-at"}, {"setThinning", "thin="}};
  words.place = [](const Eigen::Vector3d&) { return std::string("there"); };
  EXPECT_EQ(d.text(words), "one helps: --part-at there and thin=0.5");
  words.given = [](const Proposed::Value& value) { return std::holds_alternative<double>(value) ? "n" : "7,8,9"; };
  EXPECT_EQ(d.text(words), "one helps: --part-at 7,8,9 and thin=n");
}

TEST(Diagnostic, AFaceJoinsSettingsInItsOwnWay)
{
  const Diagnostic two = givenTogether(Diagnostic(Given("addHole", 1.0)), Diagnostic(Given("addHole", 2.0)));
  const Diagnostic three = givenTogether(two, Diagnostic(Given("setThinning", 0.5)));
  EXPECT_EQ(givenTogether(Diagnostic(), two), two);
  EXPECT_EQ(givenTogether(two, Diagnostic()), two);
  EXPECT_EQ(three.text(), "addHole 1 and addHole 2 and setThinning 0.5");
  EXPECT_EQ(three.settings(), (std::vector<std::string>{"addHole", "addHole", "setThinning"}));
  Vocabulary program, script;
  program.words = {{"addHole", "--hole"}, {"setThinning", "--thin"}, {between_settings, " "}};
  EXPECT_EQ(three.text(program), "--hole 1 --hole 2 --thin 0.5");
  script.words = {{"addHole", "holes="}, {"setThinning", "thin="}, {between_settings, ", "}, {betweenValues("addHole"), " + "}};
  EXPECT_EQ(three.text(script), "holes=1 + 2, thin=0.5");
  script.words[beforeValues("addHole")] = "holes=7 + ";
  EXPECT_EQ(three.text(script), "holes=7 + 1 + 2, thin=0.5");
  EXPECT_EQ(Diagnostic("({addHole}): ", two, "; ", Given("addHole", 3.0)).text(script), "(holes=): holes=7 + 1 + 2; holes=7 + 3");
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST(Diagnostic, IsATextWhereVersion01HadOne)
{
  const Diagnostics warnings{lowStep(), "scan again"};
  std::string all;
  for (const std::string& warning : warnings)
    all += warning + "\n";
  EXPECT_EQ(all, lowStep().text() + "\nscan again\n");
  EXPECT_STREQ(warnings[1].c_str(), "scan again");
}
#pragma GCC diagnostic pop

} // namespace diagnostic_test
