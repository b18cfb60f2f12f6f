#pragma once
// Certificates that are changed, and what judges of them share: numbers and gradations, read in a way of
// their own.

#include "all_cases.hpp"
#include "program.hpp"
#include "sanitizers.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace mdm_check_test {

using Rational = mpq_class;
using Words = std::vector<std::string>;

inline Rational to_power(const Rational &x, unsigned long exponent) {
  Rational result = 1;
  for (unsigned long i = 0; i < exponent; ++i)
    result *= x;
  return result;
}

/// The root of that degree, if it is a fraction.
inline std::optional<Rational> rational_root(const Rational &x, unsigned long degree) {
  mpz_class numerator, denominator;
  if (mpz_root(numerator.get_mpz_t(), x.get_num_mpz_t(), degree) == 0 ||
      mpz_root(denominator.get_mpz_t(), x.get_den_mpz_t(), degree) == 0)
    return std::nullopt;
  return Rational(numerator, denominator);
}

inline bool is_integer_text(const std::string &text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos &&
         (text == "0" || text[0] != '0');
}

/// The value of an integer, a decimal or a fraction in its only form.
inline std::optional<Rational> value_of(const std::string &text) {
  const std::size_t slash = text.find('/');
  const std::size_t point = text.find('.');
  const std::size_t mark = std::min(slash, point);
  if (!is_integer_text(text.substr(0, mark)))
    return std::nullopt;
  if (mark == std::string::npos)
    return Rational(text);
  std::string rest = text.substr(mark + 1);
  if (slash != std::string::npos) {
    Rational fraction(text.substr(0, mark) + "/" + (is_integer_text(rest) && rest != "0" ? rest : "1"));
    fraction.canonicalize();
    return fraction.get_str() == text ? std::optional<Rational>(fraction) : std::nullopt;
  }
  if (rest.empty() || rest.find_first_not_of("0123456789") != std::string::npos || rest.back() == '0')
    return std::nullopt;
  Rational decimal(text.substr(0, mark) + rest + "/1" + std::string(rest.size(), '0'), 10);
  decimal.canonicalize();
  return decimal;
}

/// Openings to the power `root`, and masses.
struct Table {
  std::vector<Rational> x, m;
  unsigned long root = 1;
};

/// A number of decimal digits with or without a sign and a point.
inline std::optional<Rational> signed_value_of(const std::string &text) {
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string fraction = text.substr(std::min(point + 1, text.size()));
  const std::string digits = text.substr(has_sign, point - has_sign) + fraction;
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  Rational value(digits + "/1" + std::string(fraction.size(), '0'), 10);
  value.canonicalize();
  return text[0] == '-' ? Rational(-value) : value;
}

/// The openings 2^-phi to the least power at which all are fractions; a pan has no phi.
inline void read_phis(const std::vector<std::optional<Rational>> &phis, Table &table) {
  mpz_class root = 1;
  for (const std::optional<Rational> &phi : phis)
    root = phi ? mpz_class(lcm(root, phi->get_den())) : root;
  table.root = root.get_ui();
  for (const std::optional<Rational> &phi : phis) {
    const mpz_class exponent = phi ? mpz_class(*phi * root) : mpz_class(0);
    const Rational half(1, 2);
    table.x.push_back(!phi            ? Rational(0)
                      : exponent >= 0 ? to_power(half, exponent.get_ui())
                                      : to_power(2, mpz_class(-exponent).get_ui()));
  }
}

/// A gradation `size_phi,mass` in any order; none if it is wrong.
inline std::optional<Table> read_phi_table(std::istringstream &lines) {
  std::vector<std::pair<std::optional<Rational>, Rational>> rows;
  for (std::string line; std::getline(lines, line);) {
    const std::string size = line.substr(0, line.find(','));
    const std::optional<Rational> phi = signed_value_of(size);
    const std::optional<Rational> m = value_of(line.substr(line.find(',') + 1));
    if ((!phi && size != "pan") || (phi && abs(*phi) > 1000) || !m)
      return std::nullopt;
    rows.emplace_back(phi, *m);
  }
  const auto is_finer = [](const auto &a, const auto &b) {
    return b.first && (!a.first || *a.first > *b.first);
  };
  std::sort(rows.begin(), rows.end(), is_finer);
  std::vector<std::optional<Rational>> phis;
  Table table;
  for (const auto &[phi, m] : rows) {
    if (!phis.empty() && phis.back() == phi)
      return std::nullopt;
    phis.push_back(phi);
    table.m.push_back(m);
  }
  read_phis(phis, table);
  const bool some = std::any_of(table.m.begin(), table.m.end(), [](const Rational &m) { return m > 0; });
  return rows.size() >= 2 && some && table.m.back() == 0 && table.root <= 1000 ? std::optional<Table>(table)
                                                                               : std::nullopt;
}

/// A gradation `size_mm,mass` or `size_phi,mass`, ascending by size; none if it is wrong.
inline std::optional<Table> read_table(const std::string &text) {
  std::istringstream lines(text);
  std::string line;
  std::map<Rational, Rational> rows;
  std::size_t count = 0;
  std::getline(lines, line);
  if (line == "size_phi,mass")
    return read_phi_table(lines);
  for (; std::getline(lines, line); ++count) {
    const std::optional<Rational> x = value_of(line.substr(0, line.find(',')));
    const std::optional<Rational> m = value_of(line.substr(line.find(',') + 1));
    if (!x || !m)
      return std::nullopt;
    rows[*x] = *m;
  }
  Table table;
  for (const auto &row : rows) {
    table.x.push_back(row.first);
    table.m.push_back(row.second);
  }
  const bool some = std::any_of(table.m.begin(), table.m.end(), [](const Rational &m) { return m > 0; });
  return count == rows.size() && count >= 2 && some && table.m.back() == 0 ? std::optional<Table>(table)
                                                                           : std::nullopt;
}

const Rational pi_below("314159265358979323846264338327950288/100000000000000000000000000000000000");
const Rational pi_above("314159265358979323846264338327950289/100000000000000000000000000000000000");

inline Words lines_of(const std::string &text) {
  Words lines;
  std::istringstream input(text);
  for (std::string line; std::getline(input, line);)
    lines.push_back(line + "\n");
  return lines;
}

inline std::string joined(const Words &words, const std::string &delimiter = "") {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i > 0 ? delimiter : "") + words[i];
  return text;
}

/// Every word dropped, doubled and exchanged with every later one.
inline void rearrange(const Words &words, const std::string &delimiter, const std::string &before,
                      const std::string &after, std::set<std::string> &mutants) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    Words dropped = words;
    dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
    mutants.insert(before + joined(dropped, delimiter) + after);
    Words doubled = words;
    doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), words[i]);
    mutants.insert(before + joined(doubled, delimiter) + after);
    for (std::size_t k = i + 1; k < words.size(); ++k) {
      Words exchanged = words;
      std::swap(exchanged[i], exchanged[k]);
      mutants.insert(before + joined(exchanged, delimiter) + after);
    }
  }
}

/// Every run of digits one up and one down.
inline void shift_numbers(const std::string &text, std::set<std::string> &mutants) {
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
    if (end == begin || (begin > 0 && std::isdigit(static_cast<unsigned char>(text[begin - 1])) != 0))
      continue;
    for (const int shift : {-1, 1}) {
      const mpz_class number = mpz_class(text.substr(begin, end - begin), 10) + shift;
      std::string digits = number.get_str();
      if (begin > 0 && text[begin - 1] == '.' && digits.size() < end - begin)
        digits.insert(0, end - begin - digits.size(), '0');
      mutants.insert(text.substr(0, begin) + digits + text.substr(end));
    }
  }
}

inline void change_bytes(const std::string &text, std::set<std::string> &mutants) {
  for (std::size_t i = 0; i <= text.size(); ++i) {
    mutants.insert(text.substr(0, i));
    for (const char c : {'0', '1', '9', ' ', '/', '.', '\n', '-', 'e', '\0', '\xFF'}) {
      mutants.insert(text.substr(0, i) + c + text.substr(i));
      if (i < text.size())
        mutants.insert(text.substr(0, i) + c + text.substr(i + 1));
    }
    if (i < text.size()) {
      mutants.insert(text.substr(0, i) + text.substr(i + 1));
      mutants.insert(text.substr(0, i) + static_cast<char>(text[i] ^ 1) + text.substr(i + 1));
    }
  }
}

/// In each line every word dropped, doubled and exchanged; in each leaf conditions changed and added.
inline void change_leaves(const std::string &text, std::set<std::string> &mutants) {
  const Words lines = lines_of(text);
  std::string before;
  for (std::size_t i = 0; i < lines.size(); before += lines[i++]) {
    Words words;
    std::istringstream input(lines[i]);
    for (std::string word; input >> word;)
      words.push_back(word);
    const std::string after = joined(Words(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end()));
    rearrange(words, " ", before, "\n" + after, mutants);
    if (words[0] != "leaf" && words[0] != "window")
      continue;
    for (std::size_t w = 2; w < words.size(); w += 2)
      for (const char letter : std::string("fFqQrRpPexEmwnNsSdtT")) {
        Words changed = words;
        changed[w][0] = letter;
        mutants.insert(before + joined(changed, " ") + "\n" + after);
      }
    Words scaled = words;
    for (std::size_t w = 1; w < words.size(); w += 2)
      scaled[w] = mpz_class(3 * mpz_class(words[w], 10)).get_str();
    mutants.insert(before + joined(scaled, " ") + "\n" + after);
    for (const std::string condition : {"m", "n", "N", "w", "E", "r1", "R1", "p2", "P2", "x1", "q1", "f1",
                                        "F1", "s1-2", "S1-2", "d1-2", "t", "T", "P1"})
      mutants.insert(before + joined(words, " ") + " 1 " + condition + "\n" + after);
  }
}

/// Every fifth, or all of them; always every eighth with sanitizers, which take eight times as long.
inline std::set<std::string> some_of(const std::set<std::string> &mutants) {
  const std::size_t step = MDM_IS_SANITIZED ? 8 : takes_all_cases() ? 1 : 5;
  std::set<std::string> some;
  std::size_t i = 0;
  for (const std::string &mutant : mutants)
    if (i++ % step == 0)
      some.insert(some.end(), mutant);
  return some;
}

inline std::string text_of(const std::string &file) {
  return read_file(std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted" / file);
}

} // namespace mdm_check_test
