// The statements of Arnold's paper. What comes in is the survey of a suite; what goes out is a row a
// statement, with what exact numbers show and a verdict. Extremes and counts are exact. Relations between N
// and other numbers are lines of least squares through enclosures, so that every printed digit is certain and
// a verdict is one comparison of fractions; an enclosure that holds the limit decides nothing (Holds::open).

#include "papers/paper_statements.hpp"

#include "match/least_match.hpp"
#include "papers/fitted_line.hpp"
#include "papers/paper_tables.hpp"
#include "sets/set_quality.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace mdm {
namespace {

constexpr unsigned log_bits = 128;
constexpr unsigned told_digits = 3;
/// Gradations of one zeta_1 that are enough for a line.
constexpr std::size_t enough_for_a_line = 20;
constexpr const char *figures = "mdm study figures SUITE --out DIR";
constexpr const char *as_coded = "mdm published spanned-integer FILE --start 0.5 --increments 1";

using SurveyRows = std::vector<const SurveyRow *>;

std::string told(const Real &y, unsigned places = told_digits) {
  return rounded(y, places);
}

std::string told(const Interval &i) {
  return told(real_in(i));
}

std::string percent_told(std::size_t some, std::size_t all) {
  return told(Real(ratio(Integer(100 * some), Integer(all))), 4) + " %";
}

std::string in_figure(int number) {
  return fmt::format("{} (figure{}.csv)", figures, number);
}

SurveyRows all_of(const std::vector<SurveyRow> &rows) {
  SurveyRows all;
  for (const SurveyRow &row : rows)
    all.push_back(&row);
  return all;
}

/// The middle one, or between the two in the middle. \pre there is one
Rational median_of(std::vector<Rational> all) {
  std::sort(all.begin(), all.end());
  return (all[(all.size() - 1) / 2] + all[all.size() / 2]) / 2;
}

template <class Belongs>
SurveyRows rows_with(const SurveyRows &rows, Belongs belongs) {
  SurveyRows some;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(some),
               [&](const SurveyRow *row) { return belongs(*row); });
  return some;
}

// A number of a row, as it enters a line.
using Value = std::optional<Ball> (*)(const SurveyRow &);

std::optional<Ball> log_of(const Available<Real> &y) {
  return y ? std::optional(log(y->ball(log_bits))) : std::nullopt;
}
std::optional<Ball> value_of(const Available<Real> &y) {
  return y ? std::optional(y->ball(log_bits)) : std::nullopt;
}
std::optional<Ball> log_n(const SurveyRow &row) {
  return log(Ball(Rational(row.counts.exact), log_bits));
}
std::optional<Ball> log_zeta(const SurveyRow &row) {
  return log(Ball(row.zeta_1, log_bits));
}
std::optional<Ball> log_phi(const SurveyRow &row) {
  return log(Ball(row.phi_1, log_bits));
}
std::optional<Ball> index_c(const SurveyRow &row) {
  return value_of(row.i_c);
}
std::optional<Ball> index_gs(const SurveyRow &row) {
  return value_of(row.i_gs);
}
std::optional<Ball> log_c_u(const SurveyRow &row) {
  return log_of(row.c_u);
}
std::optional<Ball> log_c_c(const SurveyRow &row) {
  return log_of(row.c_c);
}

std::optional<FittedLine> line_of(const SurveyRows &rows, Value x, Value y) {
  std::vector<Ball> xs, ys;
  for (const SurveyRow *row : rows) {
    const std::optional<Ball> at = x(*row), value = y(*row);
    if (at && value) {
      xs.push_back(*at);
      ys.push_back(*value);
    }
  }
  return fitted_line(xs, ys);
}

/// The certain answer to y < limit.
Holds below(const Interval &y, const Rational &limit) {
  return y.hi < limit ? Holds::yes : y.lo >= limit ? Holds::no : Holds::open;
}

Holds above(const Interval &y, const Rational &limit) {
  return y.lo > limit ? Holds::yes : y.hi <= limit ? Holds::no : Holds::open;
}

Holds both(Holds a, Holds b) {
  return a == b ? a : a == Holds::open || b == Holds::open ? Holds::open : Holds::partly;
}

/// The lines through the gradations of each zeta_1 that has enough of them.
std::vector<FittedLine> lines_by_zeta(const SurveyRows &rows, Value x) {
  std::map<Rational, SurveyRows> groups;
  for (const SurveyRow *row : rows)
    groups[row->zeta_1].push_back(row);
  std::vector<FittedLine> lines;
  for (const auto &[zeta, members] : groups)
    if (members.size() >= enough_for_a_line)
      if (const std::optional<FittedLine> line = line_of(members, x, log_n))
        lines.push_back(*line);
  return lines;
}

// Table 1.

/// Least and greatest of a number of the rows.
struct Extremes {
  Interval least, greatest;
};

std::optional<Interval> told_in(const Available<Real> &y) {
  if (!y)
    return std::nullopt;
  const Enclosure e = enclose(*y, 15);
  return Interval(e.lower(), e.upper());
}

template <class Number>
std::optional<Extremes> extremes_of(const SurveyRows &rows, Number number) {
  std::optional<Extremes> found;
  for (const SurveyRow *row : rows) {
    const std::optional<Interval> y = number(*row);
    if (!y)
      continue;
    if (!found) {
      found = Extremes{*y, *y};
      continue;
    }
    found->least = {std::min(found->least.lo, y->lo), std::min(found->least.hi, y->hi)};
    found->greatest = {std::max(found->greatest.lo, y->lo), std::max(found->greatest.hi, y->hi)};
  }
  return found;
}

/// True if all of y has the printed number when it is rounded to as many places.
bool is_printed_as(const Interval &y, const std::string &printed) {
  const Rational p = parse_decimal(printed), half = last_digit_unit(printed) / 2;
  return p - half <= y.lo && y.hi <= p + half;
}

/// A row of Table 1.
struct TableRow {
  const char *parameter, *least, *greatest; ///< as printed
  std::optional<Interval> (*number)(const SurveyRow &);
};

const TableRow table_rows[] = {
    {"sieves in G, the pan among them", "5", "14",
     [](const SurveyRow &row) { return std::optional(Interval(Rational(row.sizes.size()))); }},
    {"x_min+1 in mm", "0.075", "25",
     [](const SurveyRow &row) { return std::optional(Interval(row.sizes[1])); }},
    {"x_max in mm", "9.5", "75",
     [](const SurveyRow &row) { return std::optional(Interval(row.sizes.back())); }},
    {"C_c", "0.2", "25.5", [](const SurveyRow &row) { return told_in(row.c_c); }},
    {"C_u", "1.2", "214.5", [](const SurveyRow &row) { return told_in(row.c_u); }},
    {"I_GS", "0.03", "0.60", [](const SurveyRow &row) { return told_in(row.i_gs); }},
    {"I_C", "0.29", "1.57", [](const SurveyRow &row) { return told_in(row.i_c); }}};

Statement table_statement(const SurveyRows &rows, const TableRow &t) {
  Statement s{fmt::format("{} from {} to {}", t.parameter, t.least, t.greatest), "Table 1", "", Holds::open,
              std::string(figures) + " (table1.csv)"};
  if (const std::optional<Extremes> e = extremes_of(rows, t.number)) {
    s.found = fmt::format("{} to {}", told(real_in(e->least), 4), told(real_in(e->greatest), 4));
    s.holds = holds_in(
        (is_printed_as(e->least, t.least) ? 1U : 0U) + (is_printed_as(e->greatest, t.greatest) ? 1U : 0U), 2);
  }
  return s;
}

Statement instances(const SurveyRows &rows) {
  return {"2750 gradations", "Table 1", std::to_string(rows.size()),
          rows.size() == 2750 ? Holds::yes : Holds::no, std::string(figures) + " (table1.csv)"};
}

Statement percent_fines(const SurveyRows &rows) {
  Statement s{"Percent fines from 0.4 to 34", "Table 1", "", Holds::open,
              std::string(figures) + " (table1.csv)"};
  const std::optional<Extremes> finest = extremes_of(
      rows, [](const SurveyRow &row) { return std::optional(Interval(Rational(100 * row.finest_share))); });
  if (!finest)
    return s;
  const auto fines = [](const SurveyRow &row) -> std::optional<Interval> {
    const auto at = std::find(row.sizes.begin(), row.sizes.end(), ratio(75, 1000));
    if (at == row.sizes.end())
      return std::nullopt;
    return Interval(Rational(100 * row.passing[static_cast<std::size_t>(at - row.sizes.begin())]));
  };
  const auto with_sieve =
      std::count_if(rows.begin(), rows.end(), [&](const SurveyRow *row) { return fines(*row).has_value(); });
  s.found = fmt::format("{} to {} % lie in the finest class, whatever its sizes", told(finest->least),
                        told(real_in(finest->greatest), 4));
  if (const std::optional<Extremes> e = extremes_of(rows, fines))
    s.found += fmt::format(
        "; fines, below 0.075 mm, are {} to {} % in the {} gradations with that sieve, and not known in the "
        "others",
        told(e->least), told(real_in(e->greatest), 4), with_sieve);
  s.holds = is_printed_as(finest->least, "0.4") && is_printed_as(finest->greatest, "34") ? Holds::partly
                                                                                         : Holds::no;
  return s;
}

Statement curvature_area(const SurveyRows &rows) {
  Statement s{"I_C is the area under the curve over the trapezoid between x_min+1 and x_max",
              "Grain sizes evaluated; Figure 1", "", Holds::open, "mdm describe FILE"};
  // Of the triangle's ratio I and P = P(x_2): (I (1 - P) + 2 P) / (1 + P).
  const auto trapezoid = [](const SurveyRow &row) -> std::optional<Interval> {
    const std::optional<Interval> i = told_in(row.i_c);
    if (!i)
      return std::nullopt;
    const Rational p = row.passing[1];
    return Interval(Rational((i->lo * (1 - p) + 2 * p) / (1 + p)),
                    Rational((i->hi * (1 - p) + 2 * p) / (1 + p)));
  };
  const std::optional<Extremes> of_trapezoid = extremes_of(rows, trapezoid),
                                of_triangle =
                                    extremes_of(rows, [](const SurveyRow &row) { return told_in(row.i_c); });
  if (!of_triangle)
    return s;
  s.found = fmt::format(
      "the area above the level P(x_2) over its triangle gives {} to {}, as Table 1 has it (0.29 to 1.57); "
      "the trapezoid would give {} to {}",
      told(of_triangle->least), told(of_triangle->greatest), told(of_trapezoid->least),
      told(of_trapezoid->greatest));
  s.holds = is_printed_as(of_trapezoid->least, "0.29") && is_printed_as(of_trapezoid->greatest, "1.57")
                ? Holds::yes
                : Holds::no;
  return s;
}

std::set<Rational> sieves_above_pan(const SurveyRows &rows) {
  std::set<Rational> all;
  for (const SurveyRow *row : rows)
    all.insert(row->sizes.begin() + 1, row->sizes.end());
  return all;
}

Statement sieve_set(const SurveyRows &rows) {
  const std::set<Rational> all = sieves_above_pan(rows);
  const bool holds = all.size() == 14 && *all.begin() == ratio(75, 1000) && *all.rbegin() == 75;
  return {"14 opening sizes from 0.075 to 75 mm", "Grain sizes evaluated",
          fmt::format("{} sieves from {} to {} mm, and a pan", all.size(), to_decimal(*all.begin()),
                      to_decimal(*all.rbegin())),
          holds ? Holds::yes : Holds::no, in_figure(1)};
}

Statement consecutive_sieves(const SurveyRows &rows) {
  const std::set<Rational> all = sieves_above_pan(rows);
  std::size_t consecutive = 0;
  for (const SurveyRow *row : rows)
    consecutive += std::equal(row->sizes.begin() + 1, row->sizes.end(), all.find(row->sizes[1])) ? 1U : 0U;
  return {"Each gradation has consecutive sieves", "Grain sizes evaluated",
          fmt::format("{} of {}", consecutive, rows.size()), holds_in(consecutive, rows.size()),
          in_figure(1)};
}

Statement example_index(const std::vector<SurveyRow> &rows) {
  Statement s{"The highlighted example has I_C = 1.09", "Figure 1", "", Holds::open, in_figure(1)};
  if (const std::optional<std::size_t> example = figure1_example(rows)) {
    s.found = fmt::format("{} of the subset has {}", rows[*example].id, told(*rows[*example].i_c, 4));
    s.holds = is_printed_as(*told_in(rows[*example].i_c), "1.09") ? Holds::yes : Holds::no;
  }
  return s;
}

// The algorithms.

using Iterations = std::size_t SurveyCounts::*;

std::size_t within(const SurveyRows &rows, Iterations iterations, std::size_t most) {
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const SurveyRow *row) { return row->counts.*iterations <= most; }));
}

std::size_t most_iterations_of(const SurveyRows &rows, Iterations iterations) {
  std::size_t most = 0;
  for (const SurveyRow *row : rows)
    most = std::max(most, row->counts.*iterations);
  return most;
}

Statement without_step_4(const SurveyRows &rows, const std::vector<Convergence> &runs) {
  const std::size_t at_once = within(rows, &SurveyCounts::middle_iterations, 1);
  const auto in_subset = static_cast<std::size_t>(std::count_if(
      runs.begin(), runs.end(), [](const Convergence &c) { return c.spanned_integer.tries.size() == 1; }));
  return {"SI needs no iteration (step 4) for over 98 % of the gradations",
          "Minimal discrete match solution; Figure 2",
          fmt::format("{} of all and {} of the subset with x_nS mid-class, as the paper's code has it; {} of "
                      "all with the 100 "
                      "sizes x_nS of the printed steps",
                      percent_told(at_once, rows.size()), percent_told(in_subset, runs.size()),
                      percent_told(within(rows, &SurveyCounts::printed_iterations, 1), rows.size())),
          100 * at_once > 98 * rows.size() ? Holds::yes : Holds::no, as_coded};
}

Statement few_iterations(const SurveyRows &rows, const std::vector<Convergence> &runs) {
  std::size_t in_subset = 0;
  for (const Convergence &c : runs)
    in_subset = std::max(in_subset, c.spanned_integer.tries.size());
  const std::size_t in_all = most_iterations_of(rows, &SurveyCounts::middle_iterations);
  constexpr std::size_t most = 3;
  return {"Where SI iterates it ends within one or two iterations more",
          "Minimal discrete match solution; Figure 2",
          fmt::format("{} tries at most in the subset and {} in all with x_nS mid-class, {} in all with the "
                      "printed steps; 3 were "
                      "asked",
                      in_subset, in_all, most_iterations_of(rows, &SurveyCounts::printed_iterations)),
          holds_in((in_subset <= most ? 1U : 0U) + (in_all <= most ? 1U : 0U), 2), as_coded};
}

Statement fixed_size_iterations(const SurveyRows &rows, const std::vector<Convergence> &runs) {
  std::size_t most = 0, inexact = 0;
  for (const Convergence &c : runs) {
    most = std::max(most, c.fixed_size.tries.size());
    inexact += c.fixed_size.is_match() ? 0U : 1U;
  }
  const Holds holds = most == 15 ? Holds::yes : Holds::no;
  return {"FS takes 1 to 15 iterations to a total error of 1 % and keeps a measurable error",
          "Minimal discrete match solution; Figure 2",
          fmt::format("up to {} in the subset, up to {} in all; {} of {} in the subset keep an error", most,
                      most_iterations_of(rows, &SurveyCounts::fixed_size_iterations), inexact, runs.size()),
          both(holds, holds_in(inexact, runs.size())), "mdm published fixed-size FILE --tolerance 1%"};
}

Statement growth_of_fixed_size(const std::vector<Convergence> &runs) {
  Interval least(1), greatest(1);
  for (const Convergence &c : runs)
    for (const PublishedTry &t : c.fixed_size.tries) {
      const Rational share = ratio(total(t.q), Integer(t.multiple * total(c.fixed_size.tries.front().q)));
      least.lo = least.hi = std::min(least.lo, share);
      greatest.lo = greatest.hi = std::max(greatest.lo, share);
    }
  return {"The particles of FS grow by a factor of N(0) with each iteration",
          "Minimal discrete match solution",
          fmt::format(
              "N(0) is added, not a factor: iteration i has {} to {} times i N(0), whose entries are rounded",
              told(least), told(greatest)),
          Holds::partly, "mdm published fixed-size FILE --tolerance 0.01%"};
}

Statement match_by_spanned_integer(const SurveyRows &rows) {
  const auto exact =
      static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [](const SurveyRow *row) {
        return row->counts.spanned_integer.has_value();
      }));
  return {
      "The result of SI satisfies Cond4", "Eq. 19",
      fmt::format(
          "{} of {} are exact matches in fractions; the printed test admits the lower sieve itself, which is "
          "no "
          "size of the class: of the openings 8, 9, 10, 11 with masses 8, 9, 11 it makes no match when x_nS "
          "starts at 10",
          exact, rows.size()),
      exact == rows.size() ? Holds::yes : holds_in(exact, rows.size()), as_coded};
}

Statement smallest_by_spanned_integer(const SurveyRows &rows) {
  std::vector<Rational> ratios;
  std::size_t smallest = 0, smallest_printed = 0;
  for (const SurveyRow *row : rows) {
    if (row->counts.spanned_integer)
      ratios.push_back(ratio(*row->counts.spanned_integer, row->counts.exact));
    smallest += row->counts.spanned_integer == row->counts.exact ? 1U : 0U;
    smallest_printed += row->counts.spanned_integer_printed == row->counts.exact ? 1U : 0U;
  }
  Statement s{"Q_SI is the smallest possible quantity of particles", "Eq. 20", "", Holds::open,
              "mdm published spanned-integer FILE"};
  if (ratios.empty())
    return s;
  const Rational greatest = *std::max_element(ratios.begin(), ratios.end());
  s.found = fmt::format("smallest for {} of {} with x_nS mid-class, as the paper's code has it (median {} "
                        "times the smallest, at "
                        "most {} times), for {} with the printed steps",
                        smallest, rows.size(), told(Real(median_of(ratios))), told(Real(greatest)),
                        smallest_printed);
  s.holds = both(holds_in(smallest, rows.size()), holds_in(smallest_printed, rows.size()));
  return s;
}

Statement arbitrarily_low_error() {
  return {"FS can reduce the error to an arbitrarily low value", "Minimal discrete match solution",
          "int(i K) is within 1/2 of i K in every class, so the shares of n classes err by at most (n + 1) / "
          "(2 i - n)",
          Holds::yes, "mdm published fixed-size FILE --tolerance 0.001%"};
}

// N and other numbers.

/// The k of the power 10^k that is nearest to n on the log scale.
unsigned order_of(const Integer &n) {
  unsigned k = 0;
  while (n * n >= power_of_ten(2 * k + 1))
    ++k;
  return k;
}

std::optional<std::pair<Integer, Integer>> count_range(const SurveyRows &rows) {
  if (rows.empty())
    return std::nullopt;
  const auto [least, greatest] =
      std::minmax_element(rows.begin(), rows.end(), [](const SurveyRow *a, const SurveyRow *b) {
        return a->counts.exact < b->counts.exact;
      });
  return std::pair((*least)->counts.exact, (*greatest)->counts.exact);
}

Statement orders_of_n(const SurveyRows &rows) {
  Statement s{"N_MDM ranges from O(10^1) to O(10^10)", "Results", "", Holds::open, in_figure(3)};
  if (const auto range = count_range(rows)) {
    s.found = fmt::format("{} to {}: on the log scale 10^{} and 10^{} are the nearest powers",
                          to_string(range->first), to_string(range->second), order_of(range->first),
                          order_of(range->second));
    s.holds =
        holds_in((order_of(range->first) == 1 ? 1U : 0U) + (order_of(range->second) == 10 ? 1U : 0U), 2);
  }
  return s;
}

/// How r, or the slope, of many lines lies.
template <class Member>
std::string spread_told(const std::vector<FittedLine> &lines, Member member) {
  std::vector<Interval> all;
  for (const FittedLine &line : lines)
    all.push_back(line.*member);
  std::sort(all.begin(), all.end(), [](const Interval &a, const Interval &b) { return a.lo < b.lo; });
  return fmt::format("{} to {}, median {}", told(all.front()), told(all.back()), told(all[all.size() / 2]));
}

Statement rising(const SurveyRows &rows, const char *statement, Value x, const char *x_name, int figure) {
  Statement s{statement, fmt::format("Results; Figure {}", figure), "", Holds::open, in_figure(figure)};
  const std::vector<FittedLine> lines = lines_by_zeta(rows, x);
  if (lines.empty())
    return s;
  const auto certain =
      static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), [](const FittedLine &line) {
        return above(line.correlation, 0) == Holds::yes;
      }));
  s.found = fmt::format(
      "of {} values of zeta_1 with {} gradations and more, log N grows with {} for {}; r is {}", lines.size(),
      enough_for_a_line, x_name, certain, spread_told(lines, &FittedLine::correlation));
  s.holds = holds_in(certain, lines.size());
  return s;
}

Statement linear_in_phi(const SurveyRows &rows) {
  Statement s{"At constant zeta_1 log N is scattered about a line in log phi_1", "Results; Figure 3", "",
              Holds::open, in_figure(3)};
  const std::vector<FittedLine> lines = lines_by_zeta(rows, log_phi);
  if (lines.empty())
    return s;
  const auto close =
      static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), [](const FittedLine &line) {
        return above(line.correlation, ratio(7, 10)) == Holds::yes;
      }));
  s.found =
      fmt::format("for {} values of zeta_1 r is {}, and the slope {}; r above 0.7 was asked", lines.size(),
                  spread_told(lines, &FittedLine::correlation), spread_told(lines, &FittedLine::slope));
  s.holds = holds_in(close, lines.size());
  return s;
}

/// The slope of log N over log zeta_1 is within `margin` of 1.
Statement one_to_one(const SurveyRows &some, const std::string &statement, const std::string &who,
                     const Rational &margin, int figure) {
  Statement s{statement, fmt::format("Results; Figure {}", figure), "", Holds::open, in_figure(figure)};
  const std::optional<FittedLine> line = line_of(some, log_zeta, log_n);
  if (!line)
    return s;
  s.found = fmt::format("{} gradations with {}: slope {}, r {}; a slope within {} of 1 was asked",
                        line->points, who, told(line->slope), told(line->correlation), to_decimal(margin));
  s.holds = both(above(line->slope, 1 - margin), below(line->slope, 1 + margin));
  return s;
}

Statement by_phi(const SurveyRows &rows) {
  return one_to_one(rows_with(rows,
                              [](const SurveyRow &row) {
                                return ratio(35, 100) < row.phi_1 && row.phi_1 < ratio(45, 100);
                              }),
                    "For phi_1 near 0.4 log zeta_1 goes roughly 1:1 with log N", "0.35 < phi_1 < 0.45",
                    ratio(1, 10), 3);
}

Statement by_curvature_index(const SurveyRows &rows) {
  return one_to_one(rows_with(rows,
                              [](const SurveyRow &row) {
                                const std::optional<Interval> i = told_in(row.i_c);
                                return i && ratio(65, 100) < i->lo && i->hi < ratio(75, 100);
                              }),
                    "For I_C near 0.7 log zeta_1 goes very roughly 1:1 with log N", "0.65 < I_C < 0.75",
                    ratio(2, 10), 4);
}

Statement color_bands(const SurveyRows &rows) {
  std::map<Rational, std::set<std::pair<Rational, Rational>>> ends;
  std::set<std::pair<Rational, Rational>> all;
  for (const SurveyRow *row : rows) {
    const std::pair<Rational, Rational> pair(row->sizes[1], row->sizes.back());
    ends[row->zeta_1].insert(pair);
    all.insert(pair);
  }
  return {"Bands of log zeta_1 are distinct combinations of the smallest and the largest sieve",
          "Results; Figure 3",
          fmt::format("{} combinations have {} values of zeta_1", all.size(), ends.size()),
          all.size() == ends.size() ? Holds::yes : Holds::partly, in_figure(3)};
}

Statement mass_in_fines(const SurveyRows &rows) {
  Statement s{"Curves with a high I_C have larger relative masses at the smaller sizes", "Results", "",
              Holds::open, in_figure(4)};
  if (const std::optional<FittedLine> line = line_of(rows, index_c, log_phi)) {
    s.found = fmt::format("r of I_C and log phi_1 is {}; above 0.5 was asked", told(line->correlation));
    s.holds = above(line->correlation, ratio(1, 2));
  }
  return s;
}

Statement uncorrelated(const SurveyRows &rows, const char *what, Value x) {
  Statement s{fmt::format("{} does not correlate well with N", what), "Results", "", Holds::open,
              in_figure(5)};
  if (const std::optional<FittedLine> line = line_of(rows, x, log_n)) {
    s.found = fmt::format("r with log N is {}; |r| below 0.5 was asked", told(line->correlation));
    s.holds = below(absolute(line->correlation), ratio(1, 2));
  }
  return s;
}

Statement insufficient(const SurveyRows &rows) {
  Statement s{"USCS group, I_C, and the ratios of size and mass alone do not characterize N", "Conclusions",
              "", Holds::open, std::string(figures)};
  const std::optional<FittedLine> zeta = line_of(rows, log_zeta, log_n), phi = line_of(rows, log_phi, log_n),
                                  i_c = line_of(rows, index_c, log_n);
  if (!zeta || !phi || !i_c)
    return s;
  std::map<Rational, SurveyRows> groups;
  for (const SurveyRow *row : rows)
    groups[row->zeta_1].push_back(row);
  Rational widest = 1;
  for (const auto &[value, members] : groups) {
    const auto range = count_range(members);
    widest = std::max(widest, ratio(range->second, range->first));
  }
  s.found = fmt::format("r with log N is {} for log zeta_1, {} for log phi_1, {} for I_C; at one zeta_1 N "
                        "differs by up to {} times, "
                        "and ten times was asked",
                        told(zeta->correlation), told(phi->correlation), told(i_c->correlation),
                        told(Real(widest)));
  s.holds = widest >= 10 ? Holds::yes : Holds::no;
  return s;
}

// USCS groups (Figure 5).

/// The gradations of one group name.
class Groups {
public:
  explicit Groups(const SurveyRows &rows) {
    for (const SurveyRow *row : rows)
      if (row->group)
        groups_[row->group->name].push_back(row);
  }

  const std::map<std::string, SurveyRows> &all() const { return groups_; }
  const SurveyRows &named(const std::string &name) const {
    static const SurveyRows none;
    const auto found = groups_.find(name);
    return found == groups_.end() ? none : found->second;
  }

private:
  std::map<std::string, SurveyRows> groups_;
};

Rational median_of(const SurveyRows &rows) {
  std::vector<Rational> all;
  for (const SurveyRow *row : rows)
    all.emplace_back(row->counts.exact);
  return median_of(std::move(all));
}

/// `4 to 99, median 8, of 12`.
std::string range_told(const SurveyRows &rows) {
  const auto range = count_range(rows);
  return range ? fmt::format("{} to {}, median {}, of {}", to_string(range->first), to_string(range->second),
                             to_decimal(median_of(rows)), rows.size())
               : "none in the suite";
}

std::string group_told(const Groups &groups, const std::string &name) {
  return name + ": " + range_told(groups.named(name));
}

const std::string &all_of_parts(std::string &text, const std::vector<std::string> &parts) {
  for (const std::string &part : parts)
    text += (text.empty() ? "" : "; ") + part;
  return text;
}

std::string groups_told(const Groups &groups, const std::vector<std::string> &names) {
  std::vector<std::string> parts;
  for (const std::string &name : names)
    parts.push_back(group_told(groups, name));
  std::string text;
  return all_of_parts(text, parts);
}

Statement group_statement(const Groups &groups, const char *statement, const std::vector<std::string> &names,
                          const char *asked, const std::function<Holds()> &holds) {
  Statement s{statement, "Results; Figure 5", "", Holds::open, in_figure(5)};
  s.found = groups_told(groups, names) + "; " + asked;
  if (std::none_of(names.begin(), names.end(),
                   [&](const std::string &name) { return groups.named(name).empty(); }))
    s.holds = holds();
  return s;
}

/// The orders of magnitude between the lower ends, and between the upper ends, of two groups.
std::pair<unsigned, unsigned> end_distances(const SurveyRows &a, const SurveyRows &b) {
  const auto distance = [](const Integer &m, const Integer &n) {
    const unsigned x = order_of(m), y = order_of(n);
    return x > y ? x - y : y - x;
  };
  const auto of_a = count_range(a), of_b = count_range(b);
  return {distance(of_a->first, of_b->first), distance(of_a->second, of_b->second)};
}

Statement small_instances(const Groups &groups) {
  Statement s{"All but the broadest groups have instances of O(10^2) or less", "Results; Figure 5", "",
              Holds::open, in_figure(5)};
  std::vector<std::string> larger;
  std::size_t broad = 0;
  for (const auto &[name, rows] : groups.all())
    if (order_of(count_range(rows)->first) > 2) {
      larger.push_back(group_told(groups, name));
      broad += name.find("silt and") != std::string::npos ? 1U : 0U;
    }
  std::string text;
  s.found = fmt::format("{} of {} groups have; the others are {}", groups.all().size() - larger.size(),
                        groups.all().size(), larger.empty() ? "none" : all_of_parts(text, larger));
  if (!groups.all().empty())
    s.holds = broad == larger.size() ? Holds::yes : Holds::partly;
  return s;
}

Statement large_instances(const Groups &groups) {
  Statement s{"Groups with the smallest matches have numerous instances of O(10^6) to O(10^9)",
              "Results; Figure 5", "", Holds::open, in_figure(5)};
  std::vector<std::string> parts;
  std::size_t numerous = 0, asked = 0;
  for (const auto &[name, rows] : groups.all())
    if (order_of(count_range(rows)->first) <= 1) {
      const std::size_t large =
          rows_with(rows, [](const SurveyRow &row) { return order_of(row.counts.exact) >= 6; }).size();
      parts.push_back(fmt::format("{}: {} of {}", name, large, rows.size()));
      ++asked;
      numerous += large >= 10 ? 1U : 0U;
    }
  std::string text;
  s.found =
      "of O(10^6) and more in the groups with a match of O(10^1) or less: " + all_of_parts(text, parts) +
      "; ten were asked";
  s.holds = holds_in(numerous, asked);
  return s;
}

const char *const poor_gravel = "poorly graded gravel";
const char *const poor_gravel_sand = "poorly graded gravel with sand";
const char *const well_gravel = "well-graded gravel";
const char *const well_gravel_sand = "well-graded gravel with sand";
const char *const poor_sand = "poorly graded sand";
const char *const well_sand = "well-graded sand";

Statement well_graded_gravel(const Groups &g) {
  return group_statement(g, "Well-graded gravel tends to have larger N than poorly graded gravel",
                         {poor_gravel, well_gravel}, "a larger median was asked", [&] {
                           return median_of(g.named(well_gravel)) > median_of(g.named(poor_gravel))
                                      ? Holds::yes
                                      : Holds::no;
                         });
}

Statement gravel_with_sand(const Groups &g) {
  return group_statement(
      g, "With sand the tendency and the lower limit stay, and the upper range is higher",
      {poor_gravel, poor_gravel_sand, well_gravel, well_gravel_sand},
      "lower ends of one order, larger medians and larger upper ends were asked", [&] {
        std::size_t right =
            median_of(g.named(well_gravel_sand)) > median_of(g.named(poor_gravel_sand)) ? 1 : 0;
        for (const auto &[without, with] :
             {std::pair(poor_gravel, poor_gravel_sand), std::pair(well_gravel, well_gravel_sand)}) {
          right += end_distances(g.named(without), g.named(with)).first == 0 ? 1U : 0U;
          right += count_range(g.named(with))->second > count_range(g.named(without))->second ? 1U : 0U;
        }
        return holds_in(right, 5);
      });
}

/// Groups of which fewer than 1 % of the gradations are, none with an N below 10^4.
Statement rare_and_large(const SurveyRows &rows, const Groups &g, const char *statement,
                         const std::vector<std::string> &names) {
  return group_statement(g, statement, names, "fewer than 1 % of all, and no N below 10^4, were asked", [&] {
    std::size_t members = 0, large = 0;
    for (const std::string &name : names) {
      members += g.named(name).size();
      large += count_range(g.named(name))->first >= power_of_ten(4) ? 1U : 0U;
    }
    return both(100 * members < rows.size() ? Holds::yes : Holds::no, holds_in(large, names.size()));
  });
}

Statement similar_ranges(const Groups &g, const char *statement, const char *base,
                         const std::vector<std::string> &others) {
  std::vector<std::string> names = {base};
  names.insert(names.end(), others.begin(), others.end());
  return group_statement(g, statement, names, "ends within one order of magnitude were asked", [&] {
    std::size_t near = 0;
    for (const std::string &other : others) {
      const auto [lower, upper] = end_distances(g.named(base), g.named(other));
      near += (lower <= 1 ? 1U : 0U) + (upper <= 1 ? 1U : 0U);
    }
    return holds_in(near, 2 * others.size());
  });
}

Statement silty_sand(const Groups &g) {
  const char *const silty = "silty sand";
  return group_statement(g, "Silty sand shares orders of magnitude with poorly graded sand",
                         {poor_sand, silty}, "a range inside the other's was asked", [&] {
                           const auto a = count_range(g.named(poor_sand)), b = count_range(g.named(silty));
                           return a->first <= b->first && b->second <= a->second ? Holds::yes : Holds::partly;
                         });
}

Statement feasible(const SurveyRows &rows) {
  Statement s{"A wide range of realistic granular soils is feasible for discrete models", "Conclusions", "",
              Holds::open, in_figure(3)};
  const auto up_to = [&](unsigned order) {
    return rows_with(rows, [&](const SurveyRow &row) { return row.counts.exact <= power_of_ten(order); })
        .size();
  };
  s.found = fmt::format("N is up to 10^5 for {}, up to 10^6 for {}, up to 10^8 for {}: the paper's "
                        "introduction has 10^6 to 10^8 as "
                        "possible but rare; what is feasible is not said",
                        percent_told(up_to(5), rows.size()), percent_told(up_to(6), rows.size()),
                        percent_told(up_to(8), rows.size()));
  return s;
}

// The formula for fractals.

/// Masses of which the share 2^-k is finer than 4^-k mm, k = 0, ..., 4: fractal with D = 3 - log 2 / log 4 =
/// 5/2.
Statement fractal_formula() {
  Gradation::Data data;
  data.id = "fractal";
  data.unit = SizeUnit::mm;
  for (int k = 4; k >= 0; --k)
    data.sizes.push_back(ratio(1, Integer(power(Integer(4), static_cast<unsigned>(k)))));
  data.masses = {1, 2, 4, 8, 0};
  const Gradation fractal(std::move(data));
  const auto formula = [&](const Rational &position) {
    Rational sum = 0;
    for (std::size_t j = 0; j + 1 < fractal.sizes().size(); ++j) {
      const Rational &lower = fractal.sizes()[j], &upper = fractal.sizes()[j + 1];
      sum += fractal.masses()[j] / power(Rational(lower + position * (upper - lower)), 3);
    }
    return Rational(sum / fractal.masses()[3]); // the coarsest class has the volume of one particle of 1 mm
  };
  const Integer least = total(least_match(Problem(fractal, {}, 1)).q);
  const Rational upper = formula(1), middle = formula(ratio(1, 2)), lower = formula(0);
  return {"A formula for self-similar fractals gives the number of particles, and is sensitive to the "
          "representative radius",
          "Introduction (Tyler and Wheatcraft)",
          fmt::format("D = 2.5 between 1/256 and 1 mm, sieves 4 times apart, a particle of 1 mm in the "
                      "coarsest class: sum "
                      "m / x^3 is {} with sizes at the upper sieves, {} in the middle, {} at the lower ones; "
                      "the smallest "
                      "match has {}",
                      told(Real(upper), 7), told(Real(middle), 7), told(Real(lower), 7), to_string(least)),
          lower >= 2 * upper ? Holds::yes : Holds::no,
          "mdm published rounded FRACTAL --sizes middle; mdm solve FRACTAL"};
}

} // namespace

std::vector<Statement> paper_statements(const std::vector<SurveyRow> &rows,
                                        const std::vector<Convergence> &runs) {
  const SurveyRows all = all_of(rows);
  const Groups groups(all);
  std::vector<Statement> statements = {instances(all)};
  for (const TableRow &row : table_rows)
    statements.push_back(table_statement(all, row));
  for (Statement &s : std::vector<Statement>{
           percent_fines(all),
           curvature_area(all),
           sieve_set(all),
           consecutive_sieves(all),
           example_index(rows),
           without_step_4(all, runs),
           few_iterations(all, runs),
           fixed_size_iterations(all, runs),
           growth_of_fixed_size(runs),
           arbitrarily_low_error(),
           match_by_spanned_integer(all),
           smallest_by_spanned_integer(all),
           orders_of_n(all),
           rising(all, "A larger mass of the smallest particles tends to increase N", log_phi, "log phi_1",
                  3),
           linear_in_phi(all),
           by_phi(all),
           color_bands(all),
           rising(all, "At a given zeta_1 a larger I_C tends to increase N", index_c, "I_C", 4),
           by_curvature_index(all),
           mass_in_fines(all),
           uncorrelated(all, "C_c", log_c_c),
           uncorrelated(all, "C_u", log_c_u),
           uncorrelated(all, "I_GS", index_gs),
           small_instances(groups),
           large_instances(groups),
           well_graded_gravel(groups),
           gravel_with_sand(groups),
           rare_and_large(
               all, groups, "Gravel with silt and sand is rare and has a very large N",
               {"poorly graded gravel with silt and sand", "well-graded gravel with silt and sand"}),
           similar_ranges(groups, "Well-graded sand has a similar range to poorly graded sand", poor_sand,
                          {well_sand}),
           similar_ranges(groups, "With gravel or with silt the range of poorly graded sand changes little",
                          poor_sand, {"poorly graded sand with gravel", "poorly graded sand with silt"}),
           similar_ranges(groups, "With gravel or with silt the range of well-graded sand changes little",
                          well_sand, {"well-graded sand with gravel", "well-graded sand with silt"}),
           silty_sand(groups),
           rare_and_large(
               all, groups, "Sand with silt and gravel is rare and has a large N",
               {"poorly graded sand with silt and gravel", "well-graded sand with silt and gravel"}),
           insufficient(all),
           feasible(all),
           fractal_formula()})
    statements.push_back(std::move(s));
  return statements;
}

} // namespace mdm
