// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_iso.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

bool
ControlLanguage::runCommonCode(int code)
{
  ModalState& modal = control_.modal;
  const std::string name = "M" + std::to_string(code);
  if (code == 3 || code == 4)
    control_.startSpindle(code == 3 ? 1 : -1);
  else if (code == 5)
    modal.spindle = 0;
  else if (code == 7 || code == 8 || name == control_.job().coolant)
    modal.coolant.insert(name);
  else if (code == 9)
    modal.coolant.clear();
  else
    return false;
  return true;
}

MotionWords
ControlLanguage::placeOf(ControlWords& words) const
{
  MotionWords motion;
  for (int i = 0; i < 3; ++i)
    motion.xyz[i] = words.value(std::string(1, "XYZ"[i]));
  for (const char letter : {'A', 'B', 'C'})
    if (const auto degrees = words.value(std::string(1, letter)))
      motion.degrees[letter] = *degrees;
  return motion;
}

void
IsoLanguage::takeCodes(ControlWords& words, const std::map<std::string, std::string>& groups)
{
  codes_.clear();
  for (const ControlWord& word : words.takeAll("G")) {
    const auto group = groups.find(word.digits);
    if (group == groups.end())
      throw ControlFault("unknown word G" + word.digits);
    if (!codes_.emplace(group->second, word.digits).second)
      throw ControlFault("two codes of " + group->second);
  }
  codes_m_.clear();
  for (const ControlWord& word : words.takeAll("M"))
    codes_m_.push_back(static_cast<int>(std::lround(word.value)));
}

bool
IsoLanguage::has(const std::string& code) const
{
  return std::any_of(codes_.begin(), codes_.end(), [&](const auto& entry) { return entry.second == code; });
}

std::string
IsoLanguage::codeOf(const std::string& group) const
{
  const auto found = codes_.find(group);
  return found == codes_.end() ? std::string() : found->second;
}

void
IsoLanguage::runModes()
{
  ModalState& modal = control_.modal;
  if (const std::string units = codeOf("units"); !units.empty())
    control_.requireMetric(units == "21" || units == "71");
  if (const std::string way = codeOf("distance"); way == "91")
    throw ControlFault("incremental words");
  else if (way == "90")
    modal.absolute = true;
  modal.plane_xy = modal.plane_xy || codeOf("plane") == "17";
  if (const std::string mode = codeOf("feed"); !mode.empty()) {
    modal.feed_mode = true;
    modal.inverse_time = mode == "93";
    feed_.reset();
  }
  if (const std::string motion = codeOf("motion"); !motion.empty())
    motion_ = motion;
}

void
IsoLanguage::runFeed(ControlWords& words)
{
  inverse_.reset();
  const auto f = words.value("F");
  if (f && !(*f > 0.0))
    throw ControlFault("F is not above zero");
  if (f)
    (control_.modal.inverse_time ? inverse_ : feed_) = f;
}

void
IsoLanguage::runTool(ControlWords& words)
{
  if (const auto speed = words.value("S"))
    control_.modal.spindle_speed = *speed;
  const auto tool = words.value("T");
  const bool change = std::find(codes_m_.begin(), codes_m_.end(), 6) != codes_m_.end();
  if (tool.has_value() != change)
    throw ControlFault("T and M6 not in one line");
  if (tool)
    control_.callTool(static_cast<int>(*tool));
  codes_m_.erase(std::remove_if(codes_m_.begin(), codes_m_.end(), [&](int code) { return code == 6 || runCommonCode(code); }),
                 codes_m_.end());
}

void
IsoLanguage::runOffset()
{
  if (const std::string offset = codeOf("offset"); !offset.empty())
    control_.chooseOffset("G" + offset);
}

void
IsoLanguage::runMotion(MotionWords motion)
{
  const bool moves = motion.xyz[0] || motion.xyz[1] || motion.xyz[2] || !motion.degrees.empty() || motion.vector;
  if (inverse_ && (!moves || motion_ != "1"))
    throw ControlFault("F of inverse time without a feed move");
  if (!moves)
    return;
  if (motion_ != "0" && motion_ != "1")
    throw ControlFault("axis words without G0 or G1");
  if (inverse_)
    motion.minutes = 1.0 / *inverse_;
  else if (!control_.modal.inverse_time)
    motion.feed = feed_;
  control_.move(motion, motion_ == "0");
}

void
IsoLanguage::runEnd()
{
  for (const int code : codes_m_)
    if (code == 2 || code == 30)
      control_.modal.ended = true;
    else
      throw ControlFault("unknown word M" + std::to_string(code));
}

} // namespace pcl_spiral::test
