#include "gradation/cell_double.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mdm {

std::optional<CellDouble> cell_double(std::string_view stored) {
  double value = 0;
  const std::from_chars_result read = std::from_chars(stored.data(), stored.data() + stored.size(), value);
  if (read.ec != std::errc() || read.ptr != stored.data() + stored.size() || !std::isfinite(value))
    return std::nullopt;
  std::array<char, 32> digits{};
  // The shortest decimal that reads back; of at most 15 digits no two are the same double.
  const std::to_chars_result written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  CellDouble number{std::string(digits.data(), written.ptr), true};
  const std::string_view mantissa = std::string_view(number.text).substr(0, number.text.find('e'));
  std::string significant;
  std::copy_if(mantissa.begin(), mantissa.end(), std::back_inserter(significant), is_digit);
  significant.erase(0, std::min(significant.find_first_not_of('0'), significant.size()));
  significant.erase(significant.find_last_not_of('0') + 1);
  number.is_short = significant.size() <= 15;
  return number;
}

} // namespace mdm
