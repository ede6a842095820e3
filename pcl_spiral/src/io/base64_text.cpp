// SPDX-License-Identifier: BSD-3-Clause
#include "base64_text.h"

#include <vtkBase64Utilities.h>

namespace pcl_spiral {

std::string
base64(const void* data, std::size_t size)
{
  std::string text(4 * ((size + 2) / 3) + 4, '\0');
  text.resize(vtkBase64Utilities::Encode(static_cast<const unsigned char*>(data), size, reinterpret_cast<unsigned char*>(text.data())));
  return text;
}

} // namespace pcl_spiral
