#include "report/blend_report.hpp"

#include "blend/blend_box.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

using BlendStatus = BlendAnswer::Status;

constexpr unsigned blend_digits = 6;

/// The decimal of so many characters at most that it is, if it is one.
std::optional<std::string> decimal_within(const Rational &r, std::size_t longest) {
  std::optional<std::string> exact = exact_decimal(r);
  return exact && exact->size() <= longest ? exact : std::nullopt;
}

/// Exact if it is a short decimal, else its first digits.
std::string short_value(const Rational &r) {
  const std::optional<std::string> exact = decimal_within(r, blend_digits + 2);
  return exact ? *exact : approximate(r, blend_digits);
}

/// A share of a whole number of steps in full, where it is a decimal of no more than 12 digits.
std::string full_percent(const Rational &share) {
  constexpr std::size_t longest = 13;
  const std::optional<std::string> exact = decimal_within(100 * share, longest);
  return exact ? *exact : short_value(100 * share);
}

/// A short decimal that is no less, and behind it the fraction where it is more.
std::string least_sufficient(const Rational &r) {
  if (std::optional<std::string> exact = decimal_within(r, blend_digits + 2))
    return *std::move(exact);
  unsigned places = 0;
  while (r * power_of_ten(places) < power_of_ten(blend_digits - 1))
    ++places;
  const Rational up = ratio(ceil(Rational(r * power_of_ten(places))), power_of_ten(places));
  return fmt::format("{} ({})", to_decimal(up), to_string(r));
}

/// The same, and behind it the fraction where that is no short decimal.
std::string value_with_fraction(const Rational &r) {
  const std::string text = short_value(r);
  const std::optional<std::string> exact = exact_decimal(r);
  return exact == text ? text : fmt::format("{} ({})", text, to_string(r));
}

std::string percent_of_share(const Rational &share) {
  return short_value(100 * share);
}

std::string step_in_words(const BlendReport &r) {
  const Rational part = ratio(1, r.problem.steps);
  if (!r.mass)
    return fmt::format("steps of {} %", short_value(100 * part));
  const std::string unit = r.mass->unit.empty() ? "" : " " + printable(r.mass->unit);
  return fmt::format("steps of {}{} of {}{}", short_value(r.mass->value * part), unit,
                     short_value(r.mass->value), unit);
}

/// `61 % A, 11 % B`, without those that have no share.
std::string shares_in_words(const BlendProblem &p, const Blend &blend) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < p.stockpiles.size(); ++i)
    if (blend.shares[i] != 0)
      parts.push_back(fmt::format("{} % {}", full_percent(blend.shares[i]), printable(p.stockpiles[i].name)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// What the value of the aim is.
std::string_view aim_in_words(BlendAim aim) {
  switch (aim) {
  case BlendAim::cost:
    return "cost";
  case BlendAim::deviation:
    return "sum of the deviations from the target (points)";
  case BlendAim::max_deviation:
    return "largest deviation from the target (points)";
  case BlendAim::squares:
    return "sum of squared deviations from the target (square points)";
  default:
    return "widening of the limits (points)";
  }
}

std::string blend_headline(const BlendReport &r) {
  const BlendProblem &p = r.problem;
  const std::string limits = printable(r.specification);
  const BlendAnswer &a = r.answer;
  if (a.status == BlendStatus::none)
    return fmt::format("no blend of {}{} keeps the limits of {}{}\n",
                       p.at_most && !a.contradiction ? fmt::format("at most {} of ", *p.at_most) : "",
                       p.stockpiles.size() == 1 ? "this stockpile"
                                                : fmt::format("these {} stockpiles", p.stockpiles.size()),
                       limits, a.contradiction ? "" : " in " + step_in_words(r));
  if (a.status == BlendStatus::unknown)
    return fmt::format("the search ended before a blend within {} was found\n", limits);
  std::string text = fmt::format("{}: within {}\n", shares_in_words(p, a.best.front()), limits);
  if (p.aim == BlendAim::none)
    return text + fmt::format("  the first in {} in the order of shares\n", step_in_words(r));
  text += fmt::format("  {}: {}", aim_in_words(p.aim), value_with_fraction(a.best.front().value));
  return text + (a.status == BlendStatus::optimal
                     ? fmt::format(", the least in {}\n", step_in_words(r))
                     : fmt::format("; the search ended before all were seen, and none has less than {}\n",
                                   short_value(a.bound)));
}

/// Without an aim no real shares are the best.
bool shows_real(const BlendReport &r) {
  return r.answer.real && r.problem.aim != BlendAim::none;
}

std::string stockpile_table(const BlendReport &r) {
  const BlendProblem &p = r.problem;
  const BlendAnswer &a = r.answer;
  const bool has_cost = p.aim == BlendAim::cost;
  TextTable table;
  table.add_column("stockpile", '<');
  table.add_column("share (%)", '>');
  if (r.mass)
    table.add_column(r.mass->unit.empty() ? "mass" : "mass (" + printable(r.mass->unit) + ")", '>');
  if (has_cost)
    table.add_column("cost", '>');
  if (shows_real(r)) {
    table.add_column("real optimum (%)", '>');
    table.add_column("rounded (%)", '>');
  }
  for (std::size_t i = 0; i < p.stockpiles.size(); ++i) {
    table.add_line();
    table.add(printable(p.stockpiles[i].name));
    table.add(full_percent(a.best.front().shares[i]));
    if (r.mass)
      table.add(short_value(r.mass->value * a.best.front().shares[i]));
    if (has_cost)
      table.add(short_value(p.stockpiles[i].cost));
    if (shows_real(r)) {
      table.add(percent_of_share(a.real->shares[i]));
      table.add(full_percent(a.rounded->shares[i]));
    }
  }
  return table.text();
}

/// The distance of what passes from its nearest limit; nothing where there is none.
std::optional<Rational> slack_at(const BlendSieve &sieve, const Rational &passing) {
  std::optional<Rational> slack;
  if (sieve.least > 0)
    slack = passing - sieve.least;
  if (sieve.most < 100)
    slack = slack ? std::min(*slack, Rational(sieve.most - passing)) : Rational(sieve.most - passing);
  return slack;
}

/// What a point more room at a sieve saves of the value, at the real optimum; nothing where it saves nothing.
std::optional<Rational> price_at(const BlendAnswer &a, std::size_t sieve) {
  for (const BlendMultiple &m : a.prices)
    if (m.limit.kind == BlendLimit::Kind::passing && m.limit.index == sieve)
      return m.multiplier;
  return std::nullopt;
}

std::string sieve_table(const BlendReport &r, const Blend &blend) {
  const BlendProblem &p = r.problem;
  const bool has_target = !p.sieves.empty() && p.sieves.front().target;
  TextTable table;
  for (const char *title : {"sieve (mm)", "at least", "passing", "at most", "slack"})
    table.add_column(title, '>');
  if (has_target)
    table.add_column("target", '>');
  if (!r.answer.prices.empty())
    table.add_column("price of a point", '>');
  for (std::size_t s = p.sieves.size(); s-- > 0;) {
    const BlendSieve &sieve = p.sieves[s];
    if (!sieve.is_sieve())
      continue;
    const std::optional<Rational> slack = slack_at(sieve, blend.passing[s]);
    const std::optional<Rational> price = price_at(r.answer, s);
    table.add_line();
    table.add(short_value(sieve.size));
    table.add(sieve.least > 0 ? short_value(sieve.least) : "-");
    table.add(short_value(blend.passing[s]));
    table.add(sieve.most < 100 ? short_value(sieve.most) : "-");
    table.add(slack ? short_value(*slack) : "-");
    if (has_target)
      table.add(short_value(*sieve.target));
    if (!r.answer.prices.empty())
      table.add(price ? short_value(*price) : "-");
  }
  return table.text();
}

/// The fineness moduli of a blend, its coarseness factor, and their limits; empty where none is limited.
std::string further_limits_table(const BlendProblem &p, const Blend &blend) {
  TextTable table;
  table.add_column("", '<');
  for (const char *title : {"at least", "blend", "at most"})
    table.add_column(title, '>');
  bool is_empty = true;
  for (std::size_t s = 0; s < p.sieves.size(); ++s) {
    const BlendSieve &sieve = p.sieves[s];
    if (!sieve.modulus)
      continue;
    const auto modulus = [&sieve](const Rational &mean) {
      return short_value(modulus_of_mean(*sieve.modulus, mean));
    };
    is_empty = false;
    table.add_line();
    table.add("fineness modulus " + std::string(name(*sieve.modulus)));
    table.add(sieve.most < 100 ? modulus(sieve.most) : "-");
    table.add(modulus(blend.passing[s]));
    table.add(sieve.least > 0 ? modulus(sieve.least) : "-");
  }
  if (p.coarseness) {
    const std::optional<Rational> factor = coarseness_factor(p, blend.shares);
    is_empty = false;
    table.add_line();
    table.add("coarseness factor CF");
    table.add(p.coarseness->least > 0 ? short_value(p.coarseness->least) : "-");
    table.add(factor ? short_value(*factor) : "none");
    table.add(p.coarseness->most < 100 ? short_value(p.coarseness->most) : "-");
  }
  const bool lacks_factor = p.coarseness && !coarseness_factor(p, blend.shares);
  return is_empty ? ""
                  : "\n" + table.text() +
                        (lacks_factor
                             ? "  nothing stays on 2.36 mm: such a blend has no factor CF, and the limits "
                               "of CF do not exclude it\n"
                             : "");
}

std::string bailey_text(const BaileyReport &b) {
  const BaileyRatios ratios = bailey_ratios(b.passing);
  TextTable table;
  table.add_column("Bailey, " + short_value(b.sieves.nominal) + " mm", '<');
  table.add_column("sieves (mm)", '>');
  table.add_column("passing", '>');
  table.add_column("ratio", '>');
  const auto line = [&](const char *name, const Rational &coarser, const Rational &finer, std::size_t at,
                        const std::optional<Rational> &ratio) {
    table.add_line();
    table.add(name);
    table.add(short_value(coarser) + ", " + short_value(finer));
    table.add(short_value(b.passing[at]) + ", " + short_value(b.passing[at + 1]));
    table.add(ratio ? short_value(*ratio) : "none");
  };
  line("coarse, CA", b.sieves.half, b.sieves.primary, 0, ratios.coarse);
  line("coarse of the fine, FAc", b.sieves.primary, b.sieves.secondary, 1, ratios.fine_coarse);
  line("fine of the fine, FAf", b.sieves.secondary, b.sieves.tertiary, 2, ratios.fine_fine);
  return "\n" + table.text() +
         (b.is_interpolated
              ? "  where a stockpile lacks one of these sieves, what passes is interpolated, linear in size\n"
              : "");
}

/// What a blend breaks, in words.
std::vector<std::string> broken_in_words(const BlendProblem &p, const Blend &blend) {
  std::vector<std::string> words;
  for (const BlendLimit &limit : broken_limits(p, blend))
    words.push_back(in_words(limit, p));
  if (!keeps_at_most(p, blend))
    words.push_back(fmt::format("at most {} stockpile{}", *p.at_most, *p.at_most == 1 ? "" : "s"));
  return words;
}

/// The real optimum beside the blend in steps, and what its rounding would break.
std::string real_text(const BlendReport &r) {
  if (!shows_real(r))
    return "";
  const BlendAnswer &a = r.answer;
  std::string text =
      fmt::format("\n  of any real shares{} the least is {}\n",
                  r.problem.at_most ? ", of all stockpiles," : "", value_with_fraction(a.real->value));
  const std::vector<std::string> broken = broken_in_words(r.problem, *a.rounded);
  return text + (broken.empty()
                     ? fmt::format("  rounded to steps the real optimum keeps all limits: {}\n",
                                   value_with_fraction(a.rounded->value))
                     : fmt::format("  rounded to steps the real optimum breaks {} {}: {}\n", broken.size(),
                                   broken.size() == 1 ? "limit" : "limits", fmt::join(broken, "; ")));
}

std::string further_blends(const BlendReport &r) {
  const BlendAnswer &a = r.answer;
  std::string text;
  if (a.best.size() > 1) {
    text += "\n";
    TextTable table;
    table.add_column("rank", '>');
    if (r.problem.aim != BlendAim::none)
      table.add_column(std::string(name(r.problem.aim)), '>');
    for (const Stockpile &s : r.problem.stockpiles)
      table.add_column(printable(s.name) + " (%)", '>');
    for (std::size_t b = 0; b < a.best.size(); ++b) {
      table.add_line();
      table.add(std::to_string(b + 1));
      if (r.problem.aim != BlendAim::none)
        table.add(short_value(a.best[b].value));
      for (const Rational &share : a.best[b].shares)
        table.add(full_percent(share));
    }
    text += table.text();
  }
  if (a.is_all)
    text += fmt::format("\n  {} the limits in {}\n",
                        a.best.size() == 1 ? "no other blend keeps"
                                           : fmt::format("these {} are all blends that keep", a.best.size()),
                        step_in_words(r));
  return text;
}

std::string contradiction_text(const BlendProblem &p, const BlendContradiction &c) {
  std::vector<std::string> words;
  for (const BlendMultiple &m : c.limits)
    words.push_back(in_words(m.limit, p));
  std::string text = fmt::format("  the stockpiles cannot have {}{}:\n", fmt::join(words, " and "),
                                 words.size() > 1 ? " together" : "");
  for (std::size_t i = 0; i < words.size(); ++i)
    text += fmt::format("    {} x ({})\n", to_string(c.limits[i].multiplier), words[i]);
  if (c.sum != 0)
    text += fmt::format("    {} x (shares sum to 1)\n", to_string(c.sum));
  return text + fmt::format(
                    "  add up to 0 >= {}, as no share is negative; each of these limits is needed for that\n",
                    to_string(c.excess));
}

/// Stockpiles whose limits leave no whole number of steps.
std::string shares_without_steps(const BlendReport &r) {
  std::string text;
  const BlendBox box = whole_box(r.problem);
  for (std::size_t i = 0; i < box.least.size(); ++i)
    if (const Stockpile &s = r.problem.stockpiles[i]; box.least[i] > box.most[i])
      text += fmt::format("  no share of {} in {} is from {} to {} %: take finer steps\n", printable(s.name),
                          step_in_words(r), percent_of_share(s.least), percent_of_share(s.most));
  return text;
}

std::string widening_text(const BlendReport &r) {
  const BlendAnswer &a = r.answer;
  const std::string what =
      r.relaxed ? fmt::format("the limits at {} mm alone", short_value(*r.relaxed)) : "all limits of sieves";
  if (!a.widened_real)
    return a.is_widening_decided ? fmt::format("  no widening of {} leaves a blend\n", what) : "";
  const std::string real_shares = shares_in_words(r.problem, *a.widened_real), steps = step_in_words(r);
  const bool are_kept = a.widened_real->value == 0;
  const std::string of_all = r.problem.at_most ? " of any number of stockpiles" : "";
  std::string text = are_kept ? fmt::format("  real shares{} keep all limits: {}\n", of_all, real_shares)
                              : fmt::format("  {} must be widened by {} points for a blend{}: {}\n", what,
                                            least_sufficient(a.widened_real->value), of_all, real_shares);
  if (a.widened)
    text += fmt::format("  in {} {}by {} points: {}\n", steps, are_kept ? what + " must be widened " : "",
                        least_sufficient(a.widened->value), shares_in_words(r.problem, *a.widened));
  else if (a.is_widening_decided)
    text += fmt::format("  no widening of {} leaves a blend in {}\n", what, steps);
  return text;
}

std::string notes_text(const BlendProblem &p) {
  std::string text;
  for (const std::string &note : p.notes)
    text += "  note: " + note + "\n";
  return text.empty() ? "" : "\n" + text;
}

} // namespace

std::string blend_csv(const BlendReport &r) {
  std::string text = "rank,value";
  for (const Stockpile &s : r.problem.stockpiles)
    text += "," + csv_field(s.name + " percent");
  text += "\n";
  const auto field = [](const Rational &value) { return exact_decimal(value).value_or(to_string(value)); };
  for (std::size_t b = 0; b < r.answer.best.size(); ++b) {
    text += fmt::format("{},{}", b + 1, field(r.answer.best[b].value));
    for (const Rational &share : r.answer.best[b].shares)
      text += "," + field(100 * share);
    text += "\n";
  }
  return text;
}

std::string blend_text(const BlendReport &r) {
  const BlendAnswer &a = r.answer;
  std::string text = blend_headline(r);
  if (!a.best.empty())
    text += "\n" + stockpile_table(r) + "\n" + sieve_table(r, a.best.front()) +
            further_limits_table(r.problem, a.best.front());
  if (r.bailey)
    text += bailey_text(*r.bailey);
  if (a.status == BlendStatus::none) {
    if (a.contradiction)
      text += contradiction_text(r.problem, *a.contradiction);
    text += shares_without_steps(r) + widening_text(r);
  }
  return text + real_text(r) + further_blends(r) + notes_text(r.problem);
}

} // namespace mdm
