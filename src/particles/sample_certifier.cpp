#include "particles/sample_certifier.hpp"

#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::size_t most_line_bytes = std::size_t{1} << 20, waiting_bytes = std::size_t{64} << 10;
constexpr unsigned most_power = 1'000'000;

bool take_beginning(std::string_view &text, std::string_view beginning) {
  const bool begins = text.starts_with(beginning);
  text.remove_prefix(begins ? beginning.size() : 0);
  return begins;
}

/// The unit that a text begins with, which is taken; empty if it begins with none.
std::string_view take_unit_name(std::string_view &text) {
  for (const std::string_view unit : {"mm", "um", "m", "in"})
    if (take_beginning(text, unit))
      return unit;
  return {};
}

/// An integer in its only form; nothing else.
std::optional<Integer> canonical_integer(std::string_view text) {
  return text.size() > 1 && text.front() == '0' ? std::nullopt : parse_natural(text);
}

std::optional<Rational> decimal_of(std::string_view text) {
  try {
    return parse_decimal(text);
  } catch (const InputError &) {
    return std::nullopt;
  }
}

/// A fraction in lowest terms above 0 of at most 1000 digits; nothing else.
std::optional<Rational> fraction_of(std::string_view text) {
  const std::size_t slash = text.find('/');
  const std::optional<Integer> n = canonical_integer(text.substr(0, slash));
  const std::optional<Integer> d =
      slash == std::string_view::npos ? std::optional<Integer>(1) : canonical_integer(text.substr(slash + 1));
  if (!n || !d || *n == 0 || (slash != std::string_view::npos && *d < 2) || gcd(*n, *d) != 1)
    return std::nullopt;
  return ratio(*n, *d);
}

} // namespace

SampleCertifier::SampleCertifier(Gradation g, Question question, Begin begin, ParticleSink *next)
    : g_(std::move(g)), question_(std::move(question)), begin_(std::move(begin)), next_(next) {}

void SampleCertifier::restart() {
  if (next_ != nullptr)
    next_->restart();
  tally_.reset();
}

void SampleCertifier::begin_rows(bool is_range, unsigned power) {
  if (power > most_power)
    throw InputError(fmt::format("the sizes are roots of degree {}, of which there is no certificate: leave "
                                 "out {}",
                                 power, option("proof")));
  if (!question_.law.is_power())
    throw InputError("certificates of samples are of laws that are powers: leave out " + option("proof") +
                     ", or " + option("law") + " by table or sum");
  tally_.emplace(g_, question_.law, power);
  has_ranges_ = is_range;
  power_ = power;
  if (!begin_)
    return;
  sink_ = begin_();
  const std::string_view unit = name(g_.unit());
  waiting_ = is_range    ? fmt::format("size_lo_{0},size_hi_{0},quantity\n", unit)
             : power > 1 ? fmt::format("size_{}^{},quantity\n", unit, power)
                         : fmt::format("size_{},quantity\n", unit);
}

std::string SampleCertifier::text(const Rational &size) const {
  if (power_ > 1)
    return to_string(size);
  const std::optional<std::string> decimal = exact_decimal(size);
  if (!decimal || std::count_if(decimal->begin(), decimal->end(), [](char c) {
                    return c >= '0' && c <= '9';
                  }) > static_cast<std::ptrdiff_t>(max_decimal_digits))
    throw InputError(
        fmt::format("the size {} has no decimal of {} digits, and the certificate needs one: round "
                    "it, or leave out {}",
                    approximate(size, 15), max_decimal_digits, option("proof")));
  return *decimal;
}

void SampleCertifier::write(const SampleRow &row) {
  if (has_ranges_)
    waiting_ += fmt::format("{}{},", row.is_open ? ">" : "", text(row.lo));
  waiting_ += fmt::format("{},{}\n", text(row.hi), to_string(row.quantity));
  if (waiting_.size() >= waiting_bytes) {
    sink_(waiting_);
    waiting_.clear();
  }
}

void SampleCertifier::add_row(const SampleRow &row, bool is_range, unsigned power) {
  if (!tally_)
    begin_rows(is_range, power);
  if ((is_range && !has_ranges_ && row.lo != row.hi) || (power != power_ && power != 1))
    throw InputError("some sizes are known and of others a range, or they are roots of several degrees: a "
                     "certificate needs one kind: leave out " +
                     option("proof"));
  SampleRow powered = row;
  if (power != power_) {
    powered.lo = mdm::power(row.lo, power_);
    powered.hi = mdm::power(row.hi, power_);
  }
  tally_->add(powered);
  if (begin_)
    write(powered);
}

void SampleCertifier::add(const RootSize &diameter, const Integer &quantity) {
  if (next_ != nullptr)
    next_->add(diameter, quantity);
  add_row({diameter.power, diameter.power, quantity}, false, diameter.degree);
}

void SampleCertifier::add(const SizeRange &diameter, const Integer &quantity) {
  if (next_ != nullptr)
    next_->add(diameter, quantity);
  const bool is_open = diameter.is_open && diameter.lo < diameter.hi;
  add_row({diameter.lo, diameter.hi, quantity, is_open}, true, 1);
}

std::optional<CertifiedSample> SampleCertifier::certified() {
  if (begin_)
    sink_(waiting_);
  waiting_.clear();
  return certified_sample(g_, question_, tally_.value());
}

bool CanonicalSampleTest::take(std::string_view piece) {
  while (is_canonical_ && !piece.empty()) {
    const std::size_t end = std::min(piece.find('\n'), piece.size());
    line_ += piece.substr(0, end);
    is_canonical_ = line_.size() <= most_line_bytes;
    if (end < piece.size()) {
      is_canonical_ = is_canonical_ && take_line(line_);
      line_.clear();
    }
    piece.remove_prefix(std::min(end + 1, piece.size()));
  }
  return is_canonical_;
}

bool CanonicalSampleTest::take_line(std::string_view line) {
  if (++lines_ == 1) {
    has_range_ = take_beginning(line, "size_lo_");
    if (!has_range_ && !take_beginning(line, "size_"))
      return false;
    const std::string_view unit = take_unit_name(line);
    if (unit.empty() || (has_range_ && !take_beginning(line, fmt::format(",size_hi_{}", unit))))
      return false;
    has_power_ = !has_range_ && take_beginning(line, "^");
    if (has_power_) {
      const std::string_view digits = line.substr(0, line.find(','));
      const std::optional<Integer> power = canonical_integer(digits);
      if (!power || *power < 2 || *power > most_power)
        return false;
      line.remove_prefix(digits.size());
    }
    has_quantity_ = take_beginning(line, ",quantity");
    return line.empty();
  }
  const bool is_open = has_range_ && take_beginning(line, ">");
  std::array<std::string_view, 3> fields;
  const std::size_t count = std::size_t{1} + (has_range_ ? 1 : 0) + (has_quantity_ ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t comma = std::min(line.find(','), line.size());
    if ((comma < line.size()) != (i + 1 < count))
      return false;
    fields[i] = line.substr(0, comma);
    line.remove_prefix(std::min(comma + 1, line.size()));
  }
  const auto size = [this](std::string_view text) {
    return has_power_ ? fraction_of(text) : decimal_of(text);
  };
  const std::optional<Rational> lo = size(fields[0]), hi = has_range_ ? size(fields[1]) : lo;
  if (!lo || !hi || *hi <= 0 || *lo < 0 || (is_open ? *lo >= *hi : *lo > *hi))
    return false;
  return !has_quantity_ || canonical_integer(fields[count - 1]).value_or(0) > 0;
}

} // namespace mdm
