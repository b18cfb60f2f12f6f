#include "gradation.hpp"

#include <algorithm>
#include <iterator>

namespace mdm_check {
namespace {

struct Sieve {
  const char *opening; ///< mm
  const char *name;
};

constexpr Sieve astm_inches[] = {{"125", "5"},      {"106", "4.24"},   {"100", "4"},      {"90", "3-1/2"},
                                 {"75", "3"},       {"63", "2-1/2"},   {"53", "2.12"},    {"50", "2"},
                                 {"45", "1-3/4"},   {"37.5", "1-1/2"}, {"31.5", "1-1/4"}, {"26.5", "1.06"},
                                 {"25", "1"},       {"22.4", "7/8"},   {"19", "3/4"},     {"16", "5/8"},
                                 {"13.2", "0.530"}, {"12.5", "1/2"},   {"11.2", "7/16"},  {"9.5", "3/8"},
                                 {"8", "5/16"},     {"6.7", "0.265"},  {"6.3", "1/4"}};

constexpr Sieve astm_numbers[] = {
    {"5.6", "3-1/2"}, {"4.75", "4"},    {"4", "5"},       {"3.35", "6"},    {"2.8", "7"},
    {"2.36", "8"},    {"2", "10"},      {"1.7", "12"},    {"1.4", "14"},    {"1.18", "16"},
    {"1", "18"},      {"0.85", "20"},   {"0.71", "25"},   {"0.6", "30"},    {"0.5", "35"},
    {"0.425", "40"},  {"0.355", "45"},  {"0.3", "50"},    {"0.25", "60"},   {"0.212", "70"},
    {"0.18", "80"},   {"0.15", "100"},  {"0.125", "120"}, {"0.106", "140"}, {"0.09", "170"},
    {"0.075", "200"}, {"0.063", "230"}, {"0.053", "270"}, {"0.045", "325"}, {"0.038", "400"},
    {"0.032", "450"}, {"0.025", "500"}, {"0.02", "635"}};

constexpr Sieve tyler_numbers[] = {{"8", "2-1/2"},   {"6.7", "3"},     {"5.6", "3-1/2"}, {"4.75", "4"},
                                   {"4", "5"},       {"3.35", "6"},    {"2.8", "7"},     {"2.36", "8"},
                                   {"2", "9"},       {"1.7", "10"},    {"1.4", "12"},    {"1.18", "14"},
                                   {"1", "16"},      {"0.85", "20"},   {"0.71", "24"},   {"0.6", "28"},
                                   {"0.5", "32"},    {"0.425", "35"},  {"0.355", "42"},  {"0.3", "48"},
                                   {"0.25", "60"},   {"0.212", "65"},  {"0.18", "80"},   {"0.15", "100"},
                                   {"0.125", "115"}, {"0.106", "150"}, {"0.09", "170"},  {"0.075", "200"},
                                   {"0.063", "250"}, {"0.053", "270"}, {"0.045", "325"}, {"0.038", "400"}};

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// The name after the changes of section 4: lower case, `u` for the micro sign, no white space, `in` for
/// inches.
std::string normal_name(std::string_view name) {
  std::string out;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const std::string_view rest = name.substr(at);
    if (is_blank(name[at])) {
      std::size_t next = at;
      while (next < name.size() && is_blank(name[next]))
        ++next;
      if (!out.empty() && is_digit(out.back()) && next < name.size() && is_digit(name[next]))
        out += '-';
      at = next - 1;
    } else if (rest.substr(0, 2) == "\xC2\xB5" || rest.substr(0, 2) == "\xCE\xBC") {
      out += 'u';
      ++at;
    } else {
      out += name[at] >= 'A' && name[at] <= 'Z' ? static_cast<char>(name[at] - 'A' + 'a') : name[at];
    }
  }
  for (const std::string_view ending : {"\"", "inches", "inch", "in."})
    if (std::string_view(out).ends_with(ending))
      return out.substr(0, out.size() - ending.size()) + "in";
  return out;
}

/// v > 0 rounded to 15 significant digits, a half upwards.
mpq_class rounded_to_15_digits(const mpq_class &v, long exponent_guess) {
  const mpq_class least = ten_to(14);
  const mpq_class beyond = ten_to(15);
  long exponent = exponent_guess;
  mpq_class scaled = v * ten_to(exponent);
  for (; scaled >= beyond; --exponent)
    scaled /= 10;
  for (; scaled < least; ++exponent)
    scaled *= 10;
  scaled += mpq_class(1, 2);
  mpz_class digits;
  mpz_fdiv_q(digits.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return digits * ten_to(-exponent);
}

} // namespace

mpq_class sieve_opening(std::string_view written, char point, std::size_t line) {
  const std::string name = normal_name(written);
  std::string_view rest = name;
  const auto ends = [&](std::string_view ending) {
    const bool yes = rest.ends_with(ending);
    rest.remove_suffix(yes ? ending.size() : 0);
    return yes;
  };
  const auto begins = [&](std::string_view beginning) {
    const bool yes = rest.starts_with(beginning);
    rest.remove_prefix(yes ? beginning.size() : 0);
    return yes;
  };
  const auto found = [&](const auto &table) {
    const auto sieve =
        std::find_if(std::begin(table), std::end(table), [&](const Sieve &s) { return rest == s.name; });
    if (sieve == std::end(table))
      throw Malformed(line, quoted(written) + " is no known sieve: write its opening, such as 0.075 mm");
    return read_decimal(sieve->opening, '.', line);
  };
  if (ends("mm"))
    return read_decimal(rest, point, line);
  if (ends("um"))
    return read_decimal(rest, point, line) / 1000;
  if (ends("m"))
    return read_decimal(rest, point, line) * 1000;
  if (begins("no.") || begins("no") || begins("#"))
    return found(astm_numbers);
  if (begins("tyler")) {
    ends("mesh");
    return found(tyler_numbers);
  }
  if (!ends("in"))
    rest = {};
  return found(astm_inches);
}

mpq_class phi_opening(const mpq_class &phi, std::size_t line) {
  if (abs(phi) > 1000)
    throw Malformed(line, "a phi beyond 1000: no grain has this size");
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), phi.get_num_mpz_t(), phi.get_den_mpz_t());
  const long i = whole.get_si();
  const mpz_class two_to_i = power(2, static_cast<unsigned long>(i < 0 ? -i : i));
  const mpq_class size = i < 0 ? mpq_class(two_to_i) : mpq_class(1, two_to_i);
  const mpq_class fraction = phi - whole;
  if (fraction == 0)
    return size;

  // 2^-phi = 2^(1-fraction) * size / 2, and 2^g = exp(g ln 2) in units of 2^-bits from the series
  // ln 2 = sum 2 / ((2n+1) 3^(2n+1)) and exp y = sum y^n / n!, 0 < y < 0.7. Fewer than 2 * bits truncations,
  // each of them worth less than 8 units in the end: the value lies in [sum, sum + 16 * bits]. It is
  // irrational, so that the two ends round alike when there are enough bits.
  const mpq_class g = 1 - fraction;
  for (unsigned long bits = 128;; bits *= 2) {
    mpz_class ln2 = 0;
    mpz_class term = power(2, bits + 1) / 3;
    for (unsigned long n = 1; term > 0; n += 2, term /= 9)
      ln2 += term / n;
    const mpz_class y = ln2 * g.get_num() / g.get_den();
    mpz_class sum = 0;
    term = power(2, bits);
    for (unsigned long n = 1; term > 0; ++n) {
      sum += term;
      term *= y;
      term >>= bits;
      term /= n;
    }
    const mpq_class unit = size / (2 * power(2, bits));
    const mpz_class high = sum + 16 * bits;
    const long guess = 14 + i * 30103 / 100000;
    const mpq_class rounded = rounded_to_15_digits(sum * unit, guess);
    if (rounded == rounded_to_15_digits(high * unit, guess))
      return rounded;
  }
}

} // namespace mdm_check
