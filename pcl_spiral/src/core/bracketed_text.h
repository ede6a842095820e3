// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Text whose brackets go where something in them has no name. Private.
 */
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Text that grows by parts, some of it in brackets. A bracket in which something has no name is taken back when it closes. */
class BracketedText {
public:
  void words(const std::string& words)
  {
    for (const char c : words) {
      if (c == '(')
        open_.push_back({text_.size() - (!text_.empty() && text_.back() == ' ' ? 1 : 0), false});
      text_ += c;
      if (c == ')' && !open_.empty()) {
        if (open_.back().nameless)
          text_.erase(open_.back().begin);
        open_.pop_back();
      }
    }
  }
  void value(const std::string& text) { text_ += text; }
  /** A field that has no name here; \p own: what it is called otherwise, shown if it stands in no bracket. */
  void nameless(const std::string& own)
  {
    text_ += own;
    if (!open_.empty())
      open_.back().nameless = true;
  }
  const std::string& text() const { return text_; }

private:
  struct Bracket {
    std::size_t begin; ///< in the text, with the space before it
    bool nameless;
  };
  std::string text_;
  std::vector<Bracket> open_;
};

} // namespace pcl_spiral
