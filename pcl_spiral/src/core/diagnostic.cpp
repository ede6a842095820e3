// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/diagnostic.h>

#include "core/bracketed_text.h"
#include "core/given_together.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ostream>

namespace pcl_spiral {
namespace {

/** Four digits; numbers of 10,000 or more to the last digit before the decimal point. */
std::string
numberText(double number)
{
  const bool is_large = !(std::abs(number) < 1e4);
  char text[32];
  std::snprintf(text, sizeof text, is_large ? "%.9g" : "%.4g", is_large ? std::round(number) : number);
  return text;
}

/** Whether a field is a name of C++: "setStepOver", "Limits::gouge", "BallReach", "setTightHandling(TightHandling::Refuse)". */
bool
isSetting(const std::string& field)
{
  bool small = false;
  for (const char c : field) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != ':' && c != '(' && c != ')')
      return false;
    if ((small && std::isupper(static_cast<unsigned char>(c)) != 0) || c == ':')
      return true;
    small = small || std::islower(static_cast<unsigned char>(c)) != 0;
  }
  return false;
}

/** Whether the part \p i joins two values of one setting. */
template <typename Part>
bool
isBetweenValues(const std::vector<Part>& parts, std::size_t i)
{
  return parts[i].text == between_settings && i > 0 && i + 1 < parts.size() && parts[i - 1].is_given && parts[i + 1].is_given &&
         parts[i - 1].setting == parts[i + 1].setting;
}

/** What \p valueOf gives for each part of a kind, in their order. */
template <typename Part, typename Kind, typename ValueOf>
auto
taken(const std::vector<Part>& parts, Kind kind, ValueOf valueOf)
{
  std::vector<decltype(valueOf(parts.front()))> all;
  for (const Part& part : parts)
    if (part.kind == kind)
      all.push_back(valueOf(part));
  return all;
}

} // namespace

std::string
placeText(const Eigen::Vector3d& p)
{
  std::string all = "(";
  for (int axis = 0; axis < 3; ++axis) {
    char number[400]; // the largest double has 309 digits before the decimal point
    std::snprintf(number, sizeof number, "%.3f", p[axis]);
    std::string one = number;
    one.erase(one.find_last_not_of('0') + 1);
    if (!one.empty() && one.back() == '.')
      one.pop_back();
    all += (axis > 0 ? ", " : "") + (one == "-0" ? "0" : one);
  }
  return all + ")";
}

void
Diagnostic::add(const char* words)
{
  std::string plain;
  const auto end = [&] {
    if (!plain.empty())
      parts_.push_back({Kind::Words, std::move(plain)});
    plain.clear();
  };
  for (const char* at = words; *at != '\0'; ++at) {
    const bool doubled = (*at == '{' || *at == '}') && at[1] == *at;
    const char* const close = *at == '{' && !doubled ? std::strchr(at, '}') : nullptr;
    if (close != nullptr) {
      end();
      parts_.push_back({Kind::Field, std::string(at + 1, close)});
      at = close;
    }
    else {
      plain += *at;
      at += doubled ? 1 : 0;
    }
  }
  end();
}

void
Diagnostic::add(const std::string& name)
{
  if (!name.empty())
    parts_.push_back({Kind::Name, name});
}

void
Diagnostic::add(const Place& place)
{
  parts_.push_back({Kind::Place, {}, place.position});
}

void
Diagnostic::add(const Direction& direction)
{
  parts_.push_back({Kind::Direction, {}, direction.vector});
}

void
Diagnostic::add(double number)
{
  addNumber(numberText(number), number);
}

void
Diagnostic::add(const SixDigits& number)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number.value);
  addNumber(text, number.value);
}

void
Diagnostic::addNumber(std::string digits, double value)
{
  parts_.push_back({Kind::Number, std::move(digits), Eigen::Vector3d(value, 0.0, 0.0)});
}

void
Diagnostic::addValue(const Proposed& of_setting, bool is_given)
{
  if (const auto* number = std::get_if<double>(&of_setting.value))
    add(*number);
  else if (const auto* place = std::get_if<Eigen::Vector3d>(&of_setting.value))
    parts_.push_back({Kind::Place, {}, *place});
  else if (const auto* box = std::get_if<Extents>(&of_setting.value))
    add(*box);
  else
    parts_.push_back({Kind::Words, std::get<std::string>(of_setting.value)});
  parts_.back().setting = of_setting.setting;
  parts_.back().is_given = is_given;
}

template <typename Value>
std::vector<Value>
Diagnostic::valuesOf(bool are_given) const
{
  std::vector<Value> all;
  for (const Part& part : parts_)
    if (!part.setting.empty() && part.is_given == are_given)
      all.emplace_back(part.setting, valueOf(part));
  return all;
}

Proposed::Value
Diagnostic::valueOf(const Part& part)
{
  switch (part.kind) {
  case Kind::Number:
    return part.value.x();
  case Kind::Place:
    return part.value;
  case Kind::Box:
    return Extents{part.value, part.high};
  default:
    return part.text;
  }
}

Diagnostic
Diagnostic::renamed(const std::string& from, const std::string& to) const
{
  Diagnostic other = *this;
  for (Part& part : other.parts_)
    if (part.kind == Kind::Name && part.text == from)
      part.text = to;
  other.text_ = other.text(Vocabulary());
  return other;
}

Diagnostic
Diagnostic::renamed(const std::map<std::string, std::string>& fields) const
{
  Diagnostic other = *this;
  for (Part& part : other.parts_) {
    std::string& name = part.kind == Kind::Field ? part.text : part.setting;
    if (const auto found = fields.find(name); found != fields.end())
      name = found->second;
  }
  other.text_ = other.text(Vocabulary());
  return other;
}

Diagnostic&
Diagnostic::operator+=(const Diagnostic& other)
{
  const std::vector<Part> more = other.parts_; // other may be this one
  parts_.insert(parts_.end(), more.begin(), more.end());
  text_ = text(Vocabulary());
  return *this;
}

std::string
Diagnostic::shown(const Part& part, const Vocabulary& vocabulary) const
{
  const auto place = [&](const Eigen::Vector3d& at) { return vocabulary.place ? vocabulary.place(at) : placeText(at); };
  if (part.is_given && vocabulary.given)
    return vocabulary.given(valueOf(part));
  switch (part.kind) {
  case Kind::Place:
    return place(part.value);
  case Kind::Direction:
    return placeText(part.value);
  case Kind::Box:
    return "from " + place(part.value) + " to " + place(part.high);
  default:
    return part.text;
  }
}

std::string
Diagnostic::text(const Vocabulary& vocabulary) const
{
  BracketedText all;
  const auto name = [&](const std::string& field) {
    if (const auto named = vocabulary.words.find(field); named != vocabulary.words.end())
      all.value(named->second);
    else if (!vocabulary.has_setters && isSetting(field))
      all.nameless(field);
    else
      all.value(field);
  };
  const auto own = [&vocabulary](const std::string& words) {
    const auto found = vocabulary.words.find(words);
    return found != vocabulary.words.end() ? &found->second : nullptr;
  };
  bool goes_on = false; // with a value of the setting before
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (part.kind == Kind::Field) {
      const std::string* const between = isBetweenValues(parts_, i) ? own(betweenValues(parts_[i + 1].setting)) : nullptr;
      goes_on = between != nullptr;
      goes_on ? all.value(*between) : name(part.text);
    }
    else if (part.is_given) {
      if (!goes_on) {
        const std::string* const before = own(beforeValues(part.setting));
        before != nullptr ? all.value(*before) : name(part.setting);
        all.value(before != nullptr || all.text().back() == '=' ? "" : " "); // keywords of scripts end so
      }
      all.value(shown(part, vocabulary));
      goes_on = false;
    }
    else if (part.kind == Kind::Words)
      all.words(part.text);
    else
      all.value(shown(part, vocabulary));
  }
  return all.text();
}

std::string
Diagnostic::id() const
{
  std::string all;
  for (const Part& part : parts_) {
    if (part.is_given)
      all += '{' + part.setting + "} ";
    switch (part.kind) {
    case Kind::Words:
      for (const char c : part.text)
        all += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
      break;
    case Kind::Name:
      all += "{name}";
      break;
    case Kind::Number:
      all += "{number}";
      break;
    case Kind::Place:
      all += "{place}";
      break;
    case Kind::Direction:
      all += "{direction}";
      break;
    case Kind::Box:
      all += "from {place} to {place}";
      break;
    case Kind::Field:
      all += '{' + part.text + '}';
    }
  }
  return all;
}

std::vector<Eigen::Vector3d>
Diagnostic::places() const
{
  std::vector<Eigen::Vector3d> all;
  for (const Part& part : parts_) {
    if (part.kind == Kind::Place || part.kind == Kind::Box)
      all.push_back(part.value);
    if (part.kind == Kind::Box)
      all.push_back(part.high);
  }
  return all;
}

std::vector<Eigen::Vector3d>
Diagnostic::directions() const
{
  return taken(parts_, Kind::Direction, [](const Part& part) { return part.value; });
}

std::vector<double>
Diagnostic::numbers() const
{
  return taken(parts_, Kind::Number, [](const Part& part) { return part.value.x(); });
}

std::vector<std::string>
Diagnostic::names() const
{
  return taken(parts_, Kind::Name, [](const Part& part) { return part.text; });
}

std::vector<std::string>
Diagnostic::fields() const
{
  std::vector<std::string> all;
  for (const Part& part : parts_)
    if (part.kind == Kind::Field || part.is_given)
      all.push_back(part.is_given ? part.setting : part.text);
  return all;
}

std::vector<Proposed>
Diagnostic::proposed() const
{
  return valuesOf<Proposed>(false);
}

std::vector<Given>
Diagnostic::given() const
{
  return valuesOf<Given>(true);
}

std::vector<std::string>
Diagnostic::settings() const
{
  std::vector<std::string> all;
  for (const std::string& field : fields())
    if (isSetting(field))
      all.push_back(field);
  return all;
}

std::vector<std::string>
textsOf(const Diagnostics& diagnostics, const Vocabulary& vocabulary)
{
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : diagnostics)
    texts.push_back(diagnostic.text(vocabulary));
  return texts;
}

std::ostream&
operator<<(std::ostream& stream, const Diagnostic& diagnostic)
{
  return stream << diagnostic.text();
}

} // namespace pcl_spiral
