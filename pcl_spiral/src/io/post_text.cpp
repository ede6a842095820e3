#include "post_text.h"

#include <pcl_spiral/common/message.h>

#include <pcl_spiral/io/file_error.h>

#include <charconv>

namespace pcl_spiral {
namespace {

constexpr std::size_t full = 1 << 20; ///< bytes to write at once

} // namespace

void
PostText::word(std::string_view letters, double value)
{
  word(letters, value, decimals_);
}

void
PostText::word(std::string_view letters, double value, int decimals, bool signs)
{
  char digits[400]; // the largest double has 309 before the point
  const char* const end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  std::string_view number(digits, static_cast<std::size_t>(end - digits));
  if (number[0] == '-' && number.find_first_not_of("-0.") == std::string_view::npos)
    number.remove_prefix(1); // no sign on zero
  if (!at_start_)
    bytes_ += ' ';
  at_start_ = false;
  bytes_ += letters;
  if (signs && number[0] != '-')
    bytes_ += '+';
  bytes_ += number;
}

void
PostText::endLine(std::string_view end)
{
  bytes_ += end;
  at_start_ = true;
  if (bytes_.size() > full) {
    file_.write(bytes_);
    bytes_.clear();
  }
}

void
PostText::close()
{
  file_.write(bytes_);
  bytes_.clear();
  file_.close();
}

void
requireBlocks(const std::string& file, const MachineProgram& program)
{
  if (program.blocks.empty())
    throw FileError(file, "not written: the program has no blocks");
}

std::string
commentText(const std::string& title)
{
  std::string text = title;
  for (char& c : text)
    if (c < ' ' || c > '~' || std::string_view("()[]{};\"%").find(c) != std::string_view::npos)
      c = ' ';
  return text;
}

std::string
machineText(const MachineProgram& program)
{
  const Machine& machine = program.machine;
  const auto mount = [](const RotaryAxis& axis) { return axis.mount == RotaryMount::Table ? "table " : "head "; };
  const auto &first = machine.rotary[0], &second = machine.rotary[1];
  return commentText(textOf(machine.name.empty() ? "machine" : machine.name, ", from work to tool ", mount(first), first.letter, " ",
                            mount(second), second.letter, machine.rtcp ? ", X Y Z of the tool tip" : ", X Y Z of the machine"));
}

} // namespace pcl_spiral
