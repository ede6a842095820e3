// SPDX-License-Identifier: BSD-3-Clause
#include "packed_array.h"

#include "io/base64_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

template <typename Number>
nlohmann::ordered_json
packedNumbers(const char* type, const std::vector<Number>& numbers)
{
  return {{"type", type}, {"data", base64(numbers.data(), sizeof(Number) * numbers.size())}};
}

template nlohmann::ordered_json packedNumbers(const char*, const std::vector<std::uint8_t>&);
template nlohmann::ordered_json packedNumbers(const char*, const std::vector<std::int8_t>&);
template nlohmann::ordered_json packedNumbers(const char*, const std::vector<std::uint16_t>&);
template nlohmann::ordered_json packedNumbers(const char*, const std::vector<std::uint32_t>&);
template nlohmann::ordered_json packedNumbers(const char*, const std::vector<float>&);

nlohmann::ordered_json
packedValues(const std::vector<double>& values, std::size_t size)
{
  constexpr std::uint16_t none = 65535;
  std::vector<double> low(size, std::numeric_limits<double>::infinity()), step(size, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i]))
      low[i % size] = std::min(low[i % size], values[i]);
  for (double& l : low)
    l = std::isfinite(l) ? l : 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i]))
      step[i % size] = std::max(step[i % size], (values[i] - low[i % size]) / (none - 1));
  std::vector<std::uint16_t> numbers;
  numbers.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double unit = step[i % size] > 0.0 ? step[i % size] : 1.0;
    numbers.push_back(std::isnan(values[i]) ? none : static_cast<std::uint16_t>(std::lround((values[i] - low[i % size]) / unit)));
  }
  nlohmann::ordered_json packed = packedNumbers("u16", numbers);
  packed["low"] = low;
  packed["step"] = step;
  packed["none"] = none;
  return packed;
}

} // namespace pcl_spiral
