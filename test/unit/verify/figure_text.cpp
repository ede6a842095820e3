// SPDX-License-Identifier: BSD-3-Clause
// Figures in words: numbers, units and places fill the holes of a text.
#include "verify/figure_text.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace figure_text_test {

using namespace pcl_spiral;

namespace {

const PlacedValue place{0.0125, {1.0, -2.0, 3.25}, 17};

FigureTable
table()
{
  FigureTable table;
  table.placed("height", place, {FigureUnit::Millimetre, ".3f", true});
  table.number("length", 12345.0, {FigureUnit::Metre, ".3f"});
  table.number("share", 0.25, {FigureUnit::Share, ".3g"});
  table.number("percent", 25.0, {FigureUnit::Percent, ".3g"}).first(place);
  table.number("angle", 7.5, {FigureUnit::Degree, ".3g"});
  table.number("ratio", 0.75, {FigureUnit::None, ".3f"});
  table.count("points", 12);
  table.count("faults", 0);
  return table;
}

TEST(FigureText, NumbersHaveTheirUnitsAndDigits)
{
  EXPECT_EQ(filled("{height}, {length}, {share}, {percent}, {angle}, {ratio}, {points}", table()),
            "0.013 mm, 12.345 m, 25 %, 25 %, 7.5 degrees, 0.750, 12");
  EXPECT_EQ(filled("{#height} and {#length}", table()), "0.013 and 12.345");
}

TEST(FigureText, PagesHaveSignsAndDegreeMarks)
{
  EXPECT_EQ(filled("{height}, {angle}, {ratio}", table(), {true, "\u00b0"}), "+0.013 mm, 7.5\u00b0, 0.750");
}

TEST(FigureText, PlacesFollowTheirValue)
{
  EXPECT_EQ(filled("{height}{@height}.", table()), "0.013 mm at (1.000, -2.000, 3.250), path point 17.");
  EXPECT_EQ(filled("{percent}{@percent}", table()), "25 %, first at (1.000, -2.000, 3.250), path point 17");
  EXPECT_EQ(filled("{points}{@points}", table()), "12") << "no place";
}

TEST(FigureText, TextAroundStays)
{
  EXPECT_EQ(filled("", table()), "");
  EXPECT_EQ(filled("none", table()), "none");
  EXPECT_EQ(filled("a {points} b {points}", table()), "a 12 b 12");
}

TEST(FigureText, KnowsWhichTextsHaveAllTheirFigures)
{
  EXPECT_TRUE(allKnown("{points} of {#height}{@percent}", table()));
  EXPECT_FALSE(allKnown("{points}, {faults}", table())) << "a count of 0";
  EXPECT_FALSE(allKnown("{faults}, {points}", table()));
  FigureTable figures = table();
  figures.at("height").knownIf(false);
  EXPECT_FALSE(allKnown("{@height}", figures));
}

TEST(FigureText, AnUnknownKeyIsAnError)
{
  EXPECT_THROW(filled("{hieght}", table()), std::out_of_range);
  EXPECT_THROW(allKnown("{faults} {hieght}", table()), std::out_of_range) << "also behind a figure that is not known";
}

} // namespace

} // namespace figure_text_test
