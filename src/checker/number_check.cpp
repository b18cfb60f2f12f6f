// Matches by number (section 13): the shares q_j / N of a set, exact or within a tolerance, and that no
// smaller set has such shares. Exact shares need a multiple of their least common denominator; within a
// tolerance every smaller number is tried (Theorem 27).

#include "number_check.hpp"

#include "certificate_lines.hpp"
#include "verify.hpp"

#include <algorithm>

namespace mdm::checker {
namespace {

constexpr std::string_view first_line = "mdm-certificate number 1";
constexpr unsigned long most_tries = 1UL << 24U; // smaller numbers times classes

class NumberLines : public CertificateLines {
public:
  explicit NumberLines(std::string_view text) : CertificateLines(text, "mdm solve") {}

  mpz_class integer() {
    const mpq_class value = read_canonical(word(), line_, false);
    check(value >= 0, "a number below 0: correct it");
    return value.get_num();
  }
  std::optional<mpq_class> percent(const char *name, int most) {
    if (!take(name))
      return std::nullopt;
    const mpq_class value = read_canonical(word(), line_, true);
    check(value >= 0 && value <= most, "a tolerance out of its range: correct it");
    end();
    return value;
  }
};

/// The question with the shares g_1, ..., g_k.
struct Shares {
  Rationals retained, passing; ///< passing: of classes 1 to j
  mpz_class exact = 1;         ///< the least common multiple of their denominators

  explicit Shares(const Gradation &gradation) {
    mpq_class all = 0, sum = 0;
    for (const mpq_class &m : gradation.masses)
      all += m;
    for (std::size_t j = 0; j + 1 < gradation.masses.size(); ++j) {
      retained.push_back(gradation.masses[j] / all);
      sum += retained.back();
      passing.push_back(sum);
      exact = lcm(exact, retained.back().get_den());
    }
  }
};

/// The tolerances as shares.
struct Widths {
  std::optional<mpq_class> retained, passing, total;
  explicit Widths(const NumberCertificate &c) {
    const auto share = [](const std::optional<mpq_class> &p) {
      return p ? std::optional<mpq_class>(*p / 100) : std::nullopt;
    };
    retained = share(c.retained);
    passing = share(c.passing);
    total = share(c.total);
  }
  bool none() const { return !retained && !passing && !total; }
};

mpz_class rounded_up(const mpq_class &x) {
  mpz_class up;
  mpz_cdiv_q(up.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return up;
}
mpz_class rounded_down(const mpq_class &x) {
  mpz_class down;
  mpz_fdiv_q(down.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return down;
}

/// Whether the set has the shares that are asked for, by their definition.
bool serves(const Shares &g, const Widths &e, const std::vector<mpz_class> &quantities, const mpz_class &n) {
  mpq_class total = 0;
  mpz_class sum = 0;
  for (std::size_t j = 0; j < quantities.size(); ++j) {
    sum += quantities[j];
    const mpq_class off = abs(mpq_class(quantities[j]) / n - g.retained[j]);
    const mpq_class off_passing = abs(mpq_class(sum) / n - g.passing[j]);
    total += off;
    if ((e.none() && off != 0) || (e.retained && off > *e.retained) ||
        (e.passing && off_passing > *e.passing))
      return false;
  }
  return !e.total || total <= *e.total;
}

/// Whether n particles can be within a total: each remainder r of n g_j costs 2 r where the number is rounded
/// down, and the smallest are.
bool can_total(const Shares &g, const mpq_class &total, const mpz_class &n) {
  Rationals remainders;
  mpq_class all = 0;
  for (const mpq_class &share : g.retained) {
    const mpq_class exact = share * n;
    remainders.push_back(exact - rounded_down(exact));
    all += remainders.back();
  }
  std::sort(remainders.begin(), remainders.end());
  const std::size_t down = remainders.size() - all.get_num().get_ui(); // the sum is an integer
  mpq_class below = 0;
  for (std::size_t i = 0; i < down; ++i)
    below += remainders[i];
  return 2 * below <= total * n;
}

/// Whether n particles can be within the bounds: the sums of classes 1 to j are the integers from lo to hi.
bool can_in_bounds(const Shares &g, const Widths &e, const mpz_class &n) {
  mpz_class lo = 0, hi = 0;
  for (std::size_t j = 0; j < g.retained.size(); ++j) {
    mpz_class least = 0, most = n;
    if (e.retained) {
      least = std::max<mpz_class>(0, rounded_up((g.retained[j] - *e.retained) * n));
      most = rounded_down((g.retained[j] + *e.retained) * n);
    }
    if (least > most)
      return false;
    lo += least;
    hi += most;
    if (e.passing && j + 1 < g.retained.size()) {
      lo = std::max<mpz_class>(lo, rounded_up((g.passing[j] - *e.passing) * n));
      hi = std::min<mpz_class>(hi, rounded_down((g.passing[j] + *e.passing) * n));
    }
    if (lo > hi)
      return false;
  }
  return lo <= n && n <= hi;
}

} // namespace

bool is_number_certificate(std::string_view text) {
  return text.substr(0, text.find('\n')) == first_line;
}

NumberCertificate read_number_certificate(std::string_view text) {
  NumberLines lines(text);
  NumberCertificate c;
  lines.demand(first_line);
  lines.end();
  c.retained = lines.percent("retained", 100);
  c.passing = lines.percent("passing", 100);
  c.total = lines.percent("total", 200);
  lines.check(!c.total || (!c.retained && !c.passing), "a total stands alone: drop the other tolerances");
  const bool is_bound = lines.take("bound");
  if (!is_bound)
    lines.demand("particles");
  c.particles = lines.integer();
  lines.check(c.particles >= 1, "a set has at least 1 particle: correct the number");
  lines.end();
  if (!is_bound) {
    lines.demand("quantities");
    while (lines.more())
      c.quantities.push_back(lines.integer());
    lines.check(!c.quantities.empty(), "no quantities: give one for each class");
    lines.end();
  }
  lines.demand("end");
  lines.end_file();
  return c;
}

void verify_number(const Gradation &gradation, const NumberCertificate &c) {
  const Shares g(gradation);
  const Widths e(c);
  if (!c.quantities.empty()) {
    demand(c.quantities.size() == g.retained.size(), "there is not one quantity for each class");
    mpz_class sum = 0;
    for (const mpz_class &q : c.quantities)
      sum += q;
    demand(sum == c.particles, "the quantities do not add up to the particles");
    demand(serves(g, e, c.quantities, c.particles), "the set does not have the shares that are asked for");
  }
  if (e.none()) {
    demand(c.particles <= g.exact, "fewer particles have the exact shares");
    return;
  }
  demand(c.particles - 1 <= most_tries / static_cast<unsigned long>(g.retained.size()),
         "the smaller numbers are too many to be tried");
  for (mpz_class n = 1; n < c.particles; ++n)
    demand(!(e.total ? can_total(g, *e.total, n) : can_in_bounds(g, e, n)),
           "fewer particles can have the shares that are asked for");
}

std::string question_in_words(const NumberCertificate &c) {
  std::string words;
  const auto add = [&words](const char *name, const std::optional<mpq_class> &percent) {
    if (percent)
      words += (words.empty() ? "" : "; ") + std::string(name) + " within " + plain_decimal(*percent) +
               "% of the number";
  };
  add("retained", c.retained);
  add("passing", c.passing);
  add("total deviation", c.total);
  return std::string(c.quantities.empty() ? "a bound on the" : "the") + " smallest set by number (" +
         (words.empty() ? "exact" : words) + ")";
}

std::string accepted_number_line(const NumberCertificate &c, const std::string &file) {
  const std::string n = c.particles.get_str();
  const std::string claim = c.quantities.empty() ? "no set of fewer than " + n + " particles has"
                                                 : n + " is the least number of particles that have";
  return "accepted: " + claim + " the shares by number of " + quoted_name(file) + ": " + question_in_words(c);
}

} // namespace mdm::checker
