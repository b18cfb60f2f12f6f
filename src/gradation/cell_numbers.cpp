#include "gradation/cell_numbers.hpp"

#include "gradation/cells.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// True for a number such as 1,234 or 12,345,678, whose signs may stand between thousands.
bool may_be_thousands(std::string_view digits, char sign) {
  const std::size_t first = digits.find(sign);
  if (first == 0 || first > 3 || digits.front() == '0')
    return false;
  for (std::size_t at = first; at < digits.size(); at += 4) {
    const std::string_view group = digits.substr(at, 4);
    if (group.size() != 4 || group[0] != sign || !std::all_of(group.begin() + 1, group.end(), is_digit))
      return false;
  }
  return true;
}

[[noreturn]] void refuse_thousands(const std::string &number, const char *sign) {
  throw InputError("the number " + in_quotes(number) + " may have a decimal " + sign +
                   " or thousands: write it without thousands, or with more digits after the sign");
}

} // namespace

bool is_zero(const NumberCell &number) {
  return number.digits.find_first_of("123456789") == std::string_view::npos;
}

std::optional<NumberCell> number_cell(std::string_view cell) {
  const std::string_view text = without_spaces(cell);
  const std::size_t end = text.find_last_of("0123456789.,") + 1;
  const std::string_view digits = text.substr(0, end), behind = without_spaces(text.substr(end));
  if (digits.find_first_of("0123456789") == std::string_view::npos ||
      digits.find_first_not_of("0123456789.,+-eE") != std::string_view::npos)
    return std::nullopt;
  const ColumnUnit unit = unit_of_words(behind);
  if (!behind.empty() && unit == ColumnUnit::none)
    return std::nullopt;
  return NumberCell{digits, unit};
}

void DecimalSign::see(std::string_view digits) {
  const auto keep = [digits](std::string &place) {
    if (place.empty())
      place = digits;
  };
  if (digits.find(',') != std::string_view::npos && digits.find('.') != std::string_view::npos)
    keep(both_);
  else if (digits.find(',') != std::string_view::npos)
    keep(!comma_is_sure_ && may_be_thousands(digits, ',') ? commas_thousands_ : comma_);
  else if (digits.find('.') != std::string_view::npos)
    keep(!point_is_sure_ && may_be_thousands(digits, '.') ? points_thousands_ : point_);
}

char DecimalSign::sign() const {
  if (!both_.empty())
    throw InputError("the number " + in_quotes(both_) +
                     " has a sign between thousands: write all numbers without such signs");
  const std::string &comma = comma_.empty() ? commas_thousands_ : comma_;
  const std::string &point = point_.empty() ? points_thousands_ : point_;
  if (!comma.empty() && !point.empty())
    throw InputError(
        "the numbers " + in_quotes(comma) + " and " + in_quotes(point) +
        " have different decimal signs, or one between thousands: use one sign throughout, none between "
        "thousands");
  if (comma_.empty() && !comma.empty())
    refuse_thousands(comma, "comma");
  if (point_.empty() && !point.empty())
    refuse_thousands(point, "point");
  return comma.empty() ? '.' : ',';
}

} // namespace mdm
