// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a computation says to its user, as data: a sentence whose places, numbers, settings and units are fields.
 */
#pragma once

#include <Eigen/Core>

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace pcl_spiral {

/** A place in the coordinates of the input, mm, as a field of a Diagnostic. */
struct Place {
  explicit Place(const Eigen::Vector3d& place) : position(place) {} ///< At \p place, mm.
  Eigen::Vector3d position;                                         ///< mm
};

/** A direction, as a field of a Diagnostic: it has no unit and does not move with the coordinates. */
struct Direction {
  explicit Direction(const Eigen::Vector3d& direction) : vector(direction) {} ///< Along \p direction.
  Eigen::Vector3d vector;                                                     ///< any length
};

/** A number that is compared with another one, as a field of a Diagnostic: shown with six digits, where other real numbers have four. */
struct SixDigits {
  explicit SixDigits(double number) : value(number) {} ///< Of \p number.
  double value;                                        ///< in any unit
};

/** A box along the axes, as a field of a Diagnostic: shown as "from (0, 0, 0) to (1, 2, 3)". */
struct Extents {
  Eigen::Vector3d low;  ///< mm
  Eigen::Vector3d high; ///< mm
};

/** A value that a setting may have where something is refused, as a field of a Diagnostic: shown as the value alone. The setting is for
 *  those who try it (Diagnostic::proposed).
 *  \code
 *  Diagnostic d("thin to ", Proposed("setThinning", 0.5), " {mm} or less ({setThinning})"); // thin to 0.5 mm or less (setThinning)
 *  \endcode
 */
struct Proposed {
  using Value = std::variant<double, Eigen::Vector3d, Extents, std::string>; ///< A number, a place, a box, or the word of a choice.

  Proposed(std::string of_setting, Value of_value) : setting(std::move(of_setting)), value(std::move(of_value)) {} ///< As the members.
  /** A box, as of a keep-out, from \p low to \p high. */
  Proposed(std::string of_setting, const Eigen::Vector3d& low, const Eigen::Vector3d& high)
  : Proposed(std::move(of_setting), Extents{low, high})
  {}

  std::string setting; ///< by its C++ name
  Value value;         ///< lengths in mm; of addKeepOut a number is by how much a keep-out must grow
};

/** A setting with its value, as a user gives it: shown as "setThinning 0.5", or as the face takes it. */
struct Given : Proposed {
  using Proposed::Proposed;
};

/** How a face of the library, such as a program or a binding, names what a Diagnostic has as fields. The empty one names them as C++
 *  does. */
struct Vocabulary {
  /** The words shown for a field: {"setStepOver", "step_over="}. A field that is not in it is shown as it stands. */
  std::map<std::string, std::string> words;
  /** Whether the face has the settings of C++ that are not in words. If not, a remark in brackets that names one is left out as a whole;
   *  outside of brackets the name of C++ is shown. */
  bool has_setters = true;
  /** The text of a place; none: placeText. Lengths stay in millimetres. */
  std::function<std::string(const Eigen::Vector3d& place)> place;
  /** The text of the value of a setting, so that the face takes it (Given); none: as in sentences. */
  std::function<std::string(const Proposed::Value& value)> given;
};

/** "(12.5, -3, 0.125)": to 0.001, without trailing zeros. */
std::string placeText(const Eigen::Vector3d& place);

/** One sentence or more for a user, with the fault, the place and value, and the remedy.
 *
 *  It is made of the words in the code and of values. What stands in braces in the words is a field too: a setting by its C++ name, a
 *  unit, or words that depend on the input; a doubled brace is a brace. Each face shows fields in its own way (text(const Vocabulary&));
 *  scripts read them without the prose (id, places, numbers, settings).
 *  \code
 *  Diagnostic d("the step-over is ", step_over, " {mm} at ", Place(p), "; set it above 0 ({setStepOver})");
 *  d.text(); // the step-over is -1 mm at (1, 2, 3); set it above 0 (setStepOver)
 *  \endcode
 */
class Diagnostic {
public:
  Diagnostic() = default; ///< Nothing to say.
  /** Words of the code, with fields in braces. Implicit, so that a plain sentence is one. */
  Diagnostic(const char* words)
  {
    add(words);
    text_ = text(Vocabulary());
  }
  /** The parts one after the other: words (const char*), numbers, places, boxes, directions, values of settings (Proposed, Given), other
   *  diagnostics, and names (std::string), which are shown as they are: of files, of regions, of axes, or what another library says.
   *  What comes from outside of the code must be a std::string: in a const char* braces mean fields. Real numbers have four
   *  digits; integers, and numbers of 10,000 or more, are written to the last digit before the decimal point. */
  template <typename First, typename... Rest,
            typename = std::enable_if_t<(sizeof...(Rest) > 0) || !std::is_base_of_v<Diagnostic, std::decay_t<First>>>>
  explicit Diagnostic(const First& first, const Rest&... rest)
  {
    add(first);
    (add(rest), ...);
    text_ = text(Vocabulary());
  }

  bool empty() const { return parts_.empty(); } ///< Whether there is nothing to say.

  const std::string& text() const { return text_; }     ///< The text as C++ users read it.
  std::string text(const Vocabulary& vocabulary) const; ///< The text in the words and places of \p vocabulary.
  /** What warnings and faults were in version 0.1: a std::string.
   *  @{ */
  [[deprecated("text()")]] operator const std::string&() const { return text_; }
  [[deprecated("text().c_str()")]] const char* c_str() const { return text_.c_str(); }
  /** @} */

  /** The words without the values: "the step-over is {number} {mm} at {place}; set it above 0 ({setStepOver})". It is the same for all
   *  values, so scripts can know the kind of fault by it, and a translation can be found by it; only a list, as of separate parts, makes
   *  it longer with each entry. Braces of the words are doubled. */
  std::string id() const;
  std::vector<Eigen::Vector3d> places() const;     ///< Its places in their order, mm.
  std::vector<Eigen::Vector3d> directions() const; ///< Its directions in their order.
  std::vector<double> numbers() const;             ///< Its numbers in their order.
  std::vector<std::string> names() const;          ///< Its names in their order.
  std::vector<std::string> fields() const;         ///< What stands in braces in its words, in their order: settings, units.
  std::vector<std::string> settings() const;       ///< Of fields(), the names of C++: setters, classes and members.
  std::vector<Proposed> proposed() const;          ///< The values that it proposes for settings, in their order.
  std::vector<Given> given() const;                ///< The settings that it gives with their values, in their order.

  /** The same with the name \p to for each name \p from. */
  Diagnostic renamed(const std::string& from, const std::string& to) const;
  /** The same with other words for its fields: of a class that names settings of another one its own way. */
  Diagnostic renamed(const std::map<std::string, std::string>& fields) const;

  Diagnostic& operator+=(const Diagnostic& other); ///< Adds the parts of \p other behind these.
  /** The parts of both. */
  friend Diagnostic operator+(Diagnostic a, const Diagnostic& b) { return std::move(a += b); }
  friend bool operator==(const Diagnostic& a, const Diagnostic& b) { return a.text() == b.text(); } ///< Whether they say the same.
  friend bool operator!=(const Diagnostic& a, const Diagnostic& b) { return !(a == b); }            ///< Whether they differ.

private:
  enum class Kind {
    Words,     ///< of the code
    Name,      ///< from outside
    Number,    ///< real or whole
    Place,     ///< mm
    Direction, ///< of any length
    Box,       ///< mm
    Field      ///< what stood in braces
  };
  struct Part {
    Kind kind;
    std::string text;                                ///< of words, names and numbers as written; the name of a field
    Eigen::Vector3d value = Eigen::Vector3d::Zero(); ///< of a place or direction; the lower corner of a box; first of a number
    Eigen::Vector3d high = Eigen::Vector3d::Zero();  ///< of a box
    std::string setting = {};                        ///< of which this is a value; empty: of none
    bool is_given = false;                           ///< the setting is shown before its value
  };

  void add(const char* words);
  void add(const std::string& name);
  void add(const Place& place);
  void add(const Direction& direction);
  void add(const Extents& box) { parts_.push_back({Kind::Box, {}, box.low, box.high}); }
  void add(const Proposed& proposed) { addValue(proposed, false); }
  void add(const Given& given) { addValue(given, true); }
  void add(const Diagnostic& other) { *this += other; }
  void add(double number);
  void add(const SixDigits& number);
  template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
  void add(Integer number)
  {
    if constexpr (std::is_same_v<Integer, char>)
      add(std::string(1, number));
    else
      addNumber(std::to_string(number), static_cast<double>(number));
  }
  void addNumber(std::string digits, double value);
  void addValue(const Proposed& of_setting, bool is_given);
  static Proposed::Value valueOf(const Part& part);
  template <typename Value>
  std::vector<Value> valuesOf(bool are_given) const;
  std::string shown(const Part& part, const Vocabulary& vocabulary) const;

  std::vector<Part> parts_;
  std::string text_; ///< in the words of C++
};

/** The text as C++ users read it. */
std::ostream& operator<<(std::ostream& stream, const Diagnostic& diagnostic);

/** What a computation warns of: each in full sentences, with the remedy. */
using Diagnostics = std::vector<Diagnostic>;

/** The text of each. */
std::vector<std::string> textsOf(const Diagnostics& diagnostics, const Vocabulary& vocabulary = {});

} // namespace pcl_spiral
