// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pixels of a window.
 */
#pragma once

#include "support/picture_pixels.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_spiral::test {

/** The content of a window, without drawing it again. */
class Frame {
public:
  explicit Frame(vtkRenderWindow* window) : width_(window->GetSize()[0]), height_(window->GetSize()[1])
  {
    constexpr int front = 1;
    vtkNew<vtkUnsignedCharArray> bytes;
    window->GetPixelData(0, 0, width_ - 1, height_ - 1, front, bytes);
    bytes_.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  }
  int width() const { return width_; }
  int height() const { return height_; }
  Pixel at(int x, int y) const
  {
    const auto* const p = &bytes_[3 * (static_cast<std::size_t>(y) * width_ + x)];
    return {p[0], p[1], p[2]};
  }
  /** Number of matching pixels from column \p first to before \p last and from row \p low to before \p high. */
  std::size_t count(const std::function<bool(const Pixel&)>& matches, int first, int last, int low, int high) const
  {
    std::size_t n = 0;
    for (int y = low; y < high; ++y)
      for (int x = first; x < last; ++x)
        n += matches(at(x, y));
    return n;
  }
  std::size_t count(const std::function<bool(const Pixel&)>& matches) const { return count(matches, 0, width_, 0, height_); }
  /** Share of pixels that differ from those of \p other. */
  double difference(const Frame& other) const
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i + 2 < bytes_.size(); i += 3)
      n += bytes_[i] != other.bytes_[i] || bytes_[i + 1] != other.bytes_[i + 1] || bytes_[i + 2] != other.bytes_[i + 2];
    return static_cast<double>(n) / (static_cast<double>(width_) * height_);
  }

private:
  int width_, height_;
  std::vector<unsigned char> bytes_;
};

} // namespace pcl_spiral::test
