// SPDX-License-Identifier: BSD-3-Clause
#include "outline_line.h"

#include <cstdio>

namespace pcl_spiral::acceptance {

namespace {

template <typename... Values>
std::string
printed(const char* format, Values... values)
{
  char buffer[240];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

std::string
placeText(const test::Place& p)
{
  return printed(" at (%.2f %.2f %.2f), %.2f mm from the rim", p.at.x(), p.at.y(), p.at.z(), p.rim);
}

/** Adds cells to a line, and to the text of broken limits. */
class Cells {
public:
  explicit Cells(OutlineLine& out) : out_(out) {}

  /** A figure and its limit; \p places: decimals. NaN breaks it. */
  void atMost(const char* what, double value, double limit, int places, const std::string& where)
  {
    add(what, value, limit, places, value <= limit, where);
  }
  void atLeast(const char* what, double value, double limit, int places, const std::string& where)
  {
    add(what, value, limit, places, value >= limit, where);
  }
  void note(const std::string& text) { out_.line += text; }

private:
  void add(const char* what, double value, double limit, int places, bool held, const std::string& where)
  {
    out_.line += printed(" %7.*f%c%6.*f |", places, value, held ? ' ' : '*', places, limit);
    if (!where.empty())
      out_.places += printed("    %s %.*f", what, places, value) + where + "\n";
    if (!held)
      out_.broken += printed("    %s %.*f against %.*f", what, places, value, places, limit) + where + "\n";
  }

  OutlineLine& out_;
};

void
addFaults(const test::JudgedReport& f, Cells& cells)
{
  const auto first = [](const std::vector<test::Place>& places) {
    return places.empty() ? "" : "; first " + printed("%.4f mm", places.front().value) + placeText(places.front());
  };
  cells.atMost("crossings", static_cast<double>(f.crossings.size()), 0.0, 0, first(f.crossings));
  cells.atMost("passes", static_cast<double>(f.passes()), 1.0, 0, first(f.jumps));
  cells.atMost("rims not found", static_cast<double>(f.rims_missed), 0.0, 0, "");
}

} // namespace

std::string
outlineHeading()
{
  return "star: limit broken. Heights in h inside the fitted rims by 0.1 pitch (\"whole\": over the true "
         "surface), radii in "
         "pitches; length and time over\nthe least, within the fitted rims; radius: that 0.1 % of the path "
         "is sharper "
         "than; rev.: reversals by 150 degrees within 2 pitches; off: share of the path over half a pitch "
         "beyond the "
         "true rims\n" +
         printed("%-16s %5s | %-13s | %-13s | %-13s | %-13s | %-13s | %-13s | %-13s | %-13s | %-13s |", "outline", "turns",
                 " length  limit", "   time  limit", "  p99.9  limit", "    max  limit", "%>1.05h  limit", " radius  limit", " crossings",
                 " passes", " rims missed") +
         printed(" %5s %6s %6s %6s | %4s %5s | %5s %5s %6s %6s %6s | %6s %s", "p99", "uncut%", "gouge", "r min", "rev.", "rev.%", "p99.9",
                 "max", "%>1.05", "uncut%", "length", "off%", "mm");
}

OutlineLine
outlineLine(const OutlineRow& row, const test::JudgedReport& f, const test::JudgeSettings& settings)
{
  OutlineLine out;
  out.line = printed("%-16s %5.1f |", row.name.c_str(), f.turns);
  Cells cells(out);
  const double few = f.turns < 20.0 ? 1.0 / f.turns : 0.0;
  cells.atMost("length", f.lengthRatio(), row.length + few, 3, "");
  cells.atMost("time", f.timeRatio(settings), f.lengthRatio() + row.time, 3, "");
  cells.atMost("p99.9", f.inside.p999.value, row.p999, 3, placeText(f.inside.p999));
  cells.atMost("max", f.inside.max.value, row.max, 3, placeText(f.inside.max));
  cells.atMost("% above 1.05 h", 100.0 * f.inside.over_share, 100.0 * row.over, 3, "");
  cells.atLeast("radius", f.turning.smallest.value, row.radius, 3, placeText(f.turning.smallest));
  addFaults(f, cells);
  const test::HeightReport &in = f.inside, &all = f.whole;
  cells.note(printed(" %5.3f %6.3f %6.3f %6.3f |", in.p99.value, 100.0 * in.uncut_share, in.gouge.value, f.turning.least.value));
  cells.note(printed(" %4zu %5.2f |", f.reversals.count, 100.0 * f.reversals.share));
  cells.note(printed(" %5.3f %5.2f %6.3f %6.3f %6.3f | %6.2f %.0f", all.p999.value, all.max.value, 100.0 * all.over_share,
                     100.0 * all.uncut_share, f.trueRatio(), 100.0 * f.outside_share, f.length));
  const auto place = [&](const char* what, const test::Place& p) {
    out.places += printed("    %s %.3f", what, p.value) + placeText(p) + "\n";
  };
  place("p99", in.p99);
  place("gouge", in.gouge);
  place("least radius", f.turning.least);
  place("first reversal, degrees,", f.reversals.first);
  place("whole: p99.9", all.p999);
  place("whole: max", all.max);
  place("farthest off, mm,", f.outside);
  if (in.uncut_share > 0.0)
    out.broken += printed("    uncut: %.3f %%, farthest in", 100.0 * in.uncut_share) + placeText(in.uncut) + "\n";
  return out;
}

} // namespace pcl_spiral::acceptance
