#include "gradation/cell_double.hpp"

#include "number/nearest_double.hpp"
#include "text/lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

std::optional<CellDouble> cell_double(std::string_view stored) {
  const std::optional<double> value = nearest_double(stored);
  if (!value)
    return std::nullopt;
  // The shortest decimal that reads back; of at most 15 digits no two are the same double.
  CellDouble number{fmt::to_string(*value), true};
  const std::string_view mantissa = std::string_view(number.text).substr(0, number.text.find('e'));
  std::string significant;
  std::copy_if(mantissa.begin(), mantissa.end(), std::back_inserter(significant), is_digit);
  significant.erase(0, std::min(significant.find_first_not_of('0'), significant.size()));
  significant.erase(significant.find_last_not_of('0') + 1);
  number.is_short = significant.size() <= 15;
  return number;
}

} // namespace mdm
