#include "sample_file.hpp"

#include "text.hpp"

#include <algorithm>
#include <array>

namespace mdm::checker {
namespace {

constexpr std::size_t most_line_bytes = std::size_t{1} << 20U, most_quantity_digits = 1000;
constexpr unsigned long most_power = 1'000'000;

mpq_class in_mm(std::string_view unit) {
  return unit == "um"   ? mpq_class(1, 1000)
         : unit == "m"  ? mpq_class(1000)
         : unit == "in" ? mpq_class(254, 10)
                        : mpq_class(1);
}

/// Takes what a text begins with.
bool take(std::string_view &text, std::string_view beginning) {
  const bool begins = text.starts_with(beginning);
  text.remove_prefix(begins ? beginning.size() : 0);
  return begins;
}

/// Takes a unit that a text begins with.
std::string_view take_unit(std::string_view &text) {
  for (const std::string_view unit : {"mm", "um", "m", "in"})
    if (take(text, unit))
      return unit;
  throw Malformed(text, "the header has no unit of sizes: write size_mm, size_um, size_m or size_in");
}

} // namespace

SampleReader::SampleReader(Pieces pieces, const std::string &unit) : pieces_(std::move(pieces)) {
  read_header(unit);
}

bool SampleReader::next_line() {
  text_.clear();
  for (;;) {
    if (piece_.empty())
      piece_ = pieces_();
    if (piece_.empty()) {
      demand_form(text_.empty(), {}, "the last line has no end: add it, the file may be cut off");
      return false;
    }
    if (text_.empty())
      ++line_;
    const std::size_t end = piece_.find('\n');
    text_ += piece_.substr(0, end);
    demand_form(text_.size() <= most_line_bytes, {}, "longer than 1 MiB: give a sample, a row a line");
    piece_.remove_prefix(end == std::string_view::npos ? piece_.size() : end + 1);
    if (end != std::string_view::npos)
      return true;
  }
}

void SampleReader::read_header(const std::string &unit) {
  demand_form(next_line(), {}, "the file is empty: give a sample");
  std::string_view rest = text_;
  has_range_ = take(rest, "size_lo_");
  demand_form(has_range_ || take(rest, "size_"), {},
              "is no header of a sample that can be checked: mdm verify --proof writes one beside the "
              "certificate",
              text_);
  const std::string_view own = take_unit(rest);
  if (has_range_)
    demand_form(take(rest, ",size_hi_" + std::string(own)), {},
                "the upper bound of a size is missing, or has another unit: write size_lo_mm,size_hi_mm");
  if (!has_range_ && take(rest, "^")) {
    const std::string_view digits = rest.substr(0, rest.find(','));
    const mpz_class power = read_canonical(digits, {}, false).get_num();
    demand_form(power >= 2 && power <= most_power, {}, "is no power from 2 to 1000000: choose another",
                digits);
    power_ = power.get_ui();
    rest.remove_prefix(digits.size());
  }
  has_quantity_ = take(rest, ",quantity");
  demand_form(rest.empty(), {}, "is too much in the header: end it with the sizes, or ,quantity", rest);
  factor_ = raised(mpq_class(in_mm(own) / in_mm(unit)), power_);
}

mpq_class SampleReader::size(std::string_view text) const {
  return power_ > 1 ? read_rational(text, {}) : read_decimal(text, {});
}

bool SampleReader::next(SampleRow &row) {
  if (!next_line()) {
    demand_form(line_ > 1, {}, "there are no particles: give a row of some");
    return false;
  }
  std::array<std::string_view, 3> fields;
  const std::size_t count = 1U + (has_range_ ? 1U : 0U) + (has_quantity_ ? 1U : 0U);
  std::string_view rest = text_;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    fields[i] = rest.substr(0, comma);
    demand_form((comma < rest.size()) == (i + 1 < count), {},
                "the row has not as many fields as the header: give each of them, and no more");
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  row.is_open = has_range_ && take(fields[0], ">");
  row.lo = size(fields[0]);
  row.hi = has_range_ ? size(fields[1]) : row.lo;
  demand_form(row.hi > 0 && row.lo >= 0, {}, "a size is not above 0: give the sizes of particles");
  demand_form(row.is_open ? row.lo < row.hi : row.lo <= row.hi, {},
              "the bounds of a size do not ascend: give the lower one first");
  if (has_quantity_) {
    const std::string_view digits = fields[count - 1];
    demand_form(digits.size() <= most_quantity_digits, {}, "has too many digits: give smaller samples",
                digits);
    row.quantity = read_canonical(digits, {}, false).get_num();
    demand_form(row.quantity > 0, {}, "a quantity is 0: leave the row out");
  }
  if (factor_ != 1) {
    row.lo *= factor_;
    row.hi *= factor_;
  }
  return true;
}

} // namespace mdm::checker
