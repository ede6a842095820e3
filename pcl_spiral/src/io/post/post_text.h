// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Text of numbers and words for the writers of programs and paths.
 */
#pragma once

#include "io/byte_file.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** A program as text, built word by word; numbers do not depend on the locale. */
class PostText {
public:
  PostText(const std::string& file, int decimals) : file_(file), decimals_(decimals) {}

  /** From here on lines begin with \p letter and a number: \p first, then \p step more each; after \p last again \p step. */
  void numberLines(std::string_view letter, std::size_t first, std::size_t step, std::size_t last);
  /** A word: \p letters and the number, with the program's decimals, separated from the word before by a
   * space. */
  void word(std::string_view letters, double value);
  /** The same with \p decimals; always with a sign if \p signs. */
  void word(std::string_view letters, double value, int decimals, bool signs = false);
  /** A word without a number. */
  void code(std::string_view word);
  /** A number without letters, with \p decimals. */
  void number(double value, int decimals, bool signs = false);
  /** Text, unchanged. */
  void text(std::string_view text) { bytes_ += text; }
  void endLine(std::string_view end = "\n");
  /** A whole line of words. */
  void line(std::string_view words)
  {
    code(words);
    endLine();
  }
  /** \throw FileError */
  void close();

private:
  void separate();

  ByteFile file_;
  int decimals_;
  std::string bytes_, letter_;
  std::size_t next_ = 0, step_ = 0, last_ = 0; ///< numbers of lines; a step of 0: none
  bool at_start_ = true;
};

/** \p text with special characters turned to spaces, those of \p others, too. */
std::string plainText(std::string text, std::string_view others);

/** \p title with special characters, and those that end a comment, turned to spaces. */
std::string commentText(const std::string& title);

/** Three words of a vector, such as I J K, with 8 decimals. */
void writeVector(PostText& out, const std::array<std::string_view, 3>& letters, const Eigen::Vector3d& v, bool signs = false);

} // namespace pcl_spiral
