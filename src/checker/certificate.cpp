#include "certificate.hpp"

#include "gradation.hpp"
#include "text.hpp"

#include <algorithm>
#include <limits>

namespace mdm_check {
namespace {

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

/// Walks over the lines of a certificate and over the words of each.
class Lines {
public:
  explicit Lines(std::string_view text) : rest_(text) { next(); }

  [[noreturn]] void fail(const std::string &what) const { throw Malformed(number_, what); }

  /// Whether the line begins with this word; if so, steps behind it.
  bool take(std::string_view keyword) {
    const bool yes = line_.substr(0, line_.find(' ')) == keyword;
    if (yes)
      line_.remove_prefix(keyword.size());
    return yes;
  }
  void demand(std::string_view keyword) {
    if (!take(keyword))
      fail(quoted(line_) + " where the line " + quoted(keyword) +
           " belongs: let mdm solve --proof write it again");
  }

  bool has_word() const { return !line_.empty(); }
  std::size_t words_left() const {
    return static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ' '));
  }
  std::string_view word() {
    if (!has_word())
      fail("the line is too short: give all its numbers");
    line_.remove_prefix(1);
    const std::string_view word = line_.substr(0, line_.find(' '));
    line_.remove_prefix(word.size());
    return word;
  }

  mpz_class integer(unsigned long least) {
    const mpz_class value = integer_of(word());
    if (value < least)
      fail("a number below " + std::to_string(least) + ": raise it, or leave out a line that says nothing");
    return value;
  }
  std::uint64_t index() {
    const std::string_view text = word();
    demand_integer(text);
    if (text.size() > 18)
      fail("the index " + quoted(text) + " has more than 18 digits: no gradation has that many classes");
    std::uint64_t value = 0;
    for (const char c : text)
      value = 10 * value + static_cast<std::uint64_t>(c - '0');
    return value;
  }
  Number decimal(bool zero_allowed) {
    const std::string_view text = word();
    const std::size_t point = text.find('.');
    const std::string_view fraction = point == std::string_view::npos ? "1" : text.substr(point + 1);
    if (!all_digits(fraction) || fraction.back() == '0')
      fail(quoted(text) + " is no decimal in lowest terms: write it like 0.75");
    Number number{integer_of(text.substr(0, point)), std::string(text)};
    if (point != std::string_view::npos) {
      demand_length(text.size() - 1);
      number.value = mpq_class(mpz_class(number.text.erase(point, 1), 10), power(10, fraction.size()));
      number.value.canonicalize();
      number.text = text;
    }
    if (number.value == 0 && !zero_allowed)
      fail("a zero where a positive number belongs: leave the line out or raise it");
    return number;
  }
  mpq_class rational() {
    const std::string_view text = word();
    const std::size_t slash = text.find('/');
    mpq_class value = integer_of(text.substr(0, slash));
    if (slash != std::string_view::npos) {
      const mpz_class numerator = value.get_num();
      value = mpq_class(numerator, integer_of(text.substr(slash + 1)));
      const bool proper = value.get_den() >= 2;
      if (proper)
        value.canonicalize();
      if (!proper || value.get_num() != numerator)
        fail(quoted(text) + " is no fraction in lowest terms: write it like 3/2");
    }
    if (value == 0)
      fail("a zero where a positive number belongs");
    return value;
  }

  /// The line must be used up; steps to the next one.
  void end_line() {
    if (has_word())
      fail(quoted(line_) + " is too much on its line: drop it");
    next();
  }
  /// The line must be used up, and be the last one.
  void end_file() const {
    if (has_word() || !rest_.empty())
      fail("something follows `end`: drop it");
  }

private:
  void next() {
    const std::size_t end = rest_.find('\n');
    ++number_;
    if (end == std::string_view::npos)
      fail(rest_.empty() ? "the certificate breaks off: it has no line `end`"
                         : "the line has no end: finish it with one line feed");
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
  }
  void demand_length(std::size_t digits) const {
    if (digits > 100'000)
      fail("a number of more than 100000 digits: give fewer digits");
  }
  void demand_integer(std::string_view text) const {
    if (!all_digits(text) || (text.size() > 1 && text[0] == '0'))
      fail(quoted(text) + " is not a number as a certificate writes it: no sign, no leading zero");
    demand_length(text.size());
  }
  mpz_class integer_of(std::string_view text) const {
    demand_integer(text);
    return mpz_class(std::string(text), 10);
  }

  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

void read_law(Lines &lines, Question &question) {
  lines.demand("law");
  const mpq_class exponent = lines.rational();
  if (exponent.get_num() > 1000 || exponent.get_den() > 1000)
    lines.fail("a mass law with numbers above 1000: choose a simpler one");
  question.a = exponent.get_num().get_ui();
  question.b = exponent.get_den().get_ui();
  lines.end_line();
}

void read_options(Lines &lines, Question &question) {
  if (lines.take("pan-size")) {
    question.pan_size = lines.decimal(false);
    lines.end_line();
  }
  if (lines.take("cut-below")) {
    question.cut_below = lines.decimal(false);
    lines.end_line();
  }
  if (lines.take("size-factor")) {
    question.size_factor = lines.decimal(false);
    if (question.size_factor->value == 1)
      lines.fail("a size factor of 1 says nothing: leave the line out");
    lines.end_line();
  }
  if (lines.take("min-per-class")) {
    question.min_per_class = lines.integer(2);
    lines.end_line();
  }
}

void read_solids(Lines &lines, Question &question) {
  question.solids = lines.take("cylinder")        ? Solids::cylinder
                    : lines.take("box")           ? Solids::box
                    : lines.take("solids-volume") ? Solids::volume
                                                  : Solids::none;
  if (question.solids == Solids::none)
    return;
  if (question.a != 3 || question.b != 1)
    lines.fail("a volume of solids with a law that is not the sphere's: it needs `law 3`");
  const int lengths = question.solids == Solids::cylinder ? 2 : question.solids == Solids::box ? 3 : 1;
  for (int i = 0; i < lengths; ++i)
    question.dimensions.push_back(lines.decimal(false));
  if (question.solids != Solids::volume)
    question.dimensions.push_back(lines.decimal(true));
  lines.end_line();

  if (question.solids == Solids::cylinder)
    return;
  lines.demand("pi");
  const Number low = lines.decimal(false);
  const Number high = lines.decimal(false);
  if (std::max(low.text.size(), high.text.size()) > 1002 || low.value < 3 || low.value >= high.value ||
      high.value > 4)
    lines.fail("bounds of pi that are not 3 <= p < r <= 4 with at most 1000 digits after the point");
  question.pi_low = low.value;
  question.pi_high = high.value;
  lines.end_line();
}

void read_witness(Lines &lines, Certificate &certificate) {
  lines.demand("particles");
  certificate.particles = lines.integer(1);
  lines.end_line();
  lines.demand("scale");
  certificate.scale = lines.rational();
  lines.end_line();
  while (lines.take("class")) {
    ClassWitness witness{lines.index(), lines.integer(1), lines.decimal(false).value,
                         lines.decimal(false).value};
    if (witness.lo > witness.hi)
      lines.fail("a size whose lower bound is above its upper one: exchange them");
    if (!certificate.classes.empty() && certificate.classes.back().index >= witness.index)
      lines.fail("classes that do not ascend: sort them");
    if (certificate.classes.size() == most_rows)
      lines.fail("more classes than a gradation can have");
    certificate.classes.push_back(std::move(witness));
    lines.end_line();
  }
}

void read_chain(Lines &lines, Certificate &certificate) {
  const std::optional<mpz_class> &at_least = certificate.question.at_least;
  if (at_least && *at_least == certificate.particles)
    return;
  if (at_least && lines.take("above")) {
    certificate.above = lines.rational();
    lines.end_line();
  }
  lines.demand("chain");
  certificate.chain.emplace();
  certificate.chain->reserve(lines.words_left());
  while (lines.has_word())
    certificate.chain->push_back(static_cast<std::uint32_t>(
        std::min<std::uint64_t>(lines.index(), std::numeric_limits<std::uint32_t>::max())));
  lines.end_line();
}

} // namespace

Certificate read_certificate(std::string_view text) {
  if (text.size() > std::size_t{256} << 20U)
    throw Malformed(1, "more than 256 MiB: no certificate is that long");
  Lines lines(text);
  Certificate certificate;
  lines.demand("mdm-certificate");
  if (lines.word() != "1")
    lines.fail("a version that this checker does not know: it reads `mdm-certificate 1`");
  lines.end_line();
  read_law(lines, certificate.question);
  read_options(lines, certificate.question);
  read_solids(lines, certificate.question);
  if (lines.take("at-least")) {
    certificate.question.at_least = lines.integer(2);
    lines.end_line();
  }
  read_witness(lines, certificate);
  read_chain(lines, certificate);
  lines.demand("end");
  lines.end_file();
  return certificate;
}

} // namespace mdm_check
