#include <mdm/error.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/generated.hpp>
#include <mdm/report/versions.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr unsigned read_digits = 6; // in text
/// What is streamed is handed on in parts of some such length.
constexpr std::size_t part = std::size_t{1} << 16;

std::string pair(const Enclosure &e) {
  return fmt::format(R"(["{}","{}"])", e.lower_text(), e.upper_text());
}

std::string pair(const Real &y, unsigned digits) {
  return pair(enclose(y, digits));
}

std::string columns(const Enclosure &e) {
  return e.lower_text() + "," + e.upper_text();
}

/// Bounds and volume fraction of class j, as generated or, for a match, as rounded.
struct Shown {
  Real lower, upper, volume_fraction;
};

Shown shown(const GeneratedSet &set, std::size_t j) {
  if (!set.match)
    return {set.classes[j].lower.real, set.classes[j].upper.real, set.classes[j].volume_fraction};
  const Gradation &g = set.match->gradation;
  return {g.lower(j), g.upper(j), g.mass(j)};
}

/// The place of class j among those of the match; nothing if it is empty.
std::optional<std::size_t> place(const Match &m, std::size_t j) {
  const std::vector<ProblemClass> &classes = m.problem.classes();
  const auto at = std::find_if(classes.begin(), classes.end(), [j](const auto &c) { return c.index == j; });
  if (at == classes.end())
    return std::nullopt;
  return static_cast<std::size_t>(at - classes.begin());
}

/// Size i of the table: equal steps from d_min to d_max.
Rational table_size(const GeneratedSet &set, unsigned i) {
  const Rational low = set.curve->d_min();
  return low + (set.curve->d_max() - low) * ratio(i, set.table - 1);
}

using TakeSize =
    std::function<void(std::size_t j, const Enclosure &size, const std::optional<Rational> &exact)>;

/// All sizes of the set, class by class.
void for_each_size(const GeneratedSet &set, const Draws &draws, const TakeSize &take) {
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    const Integer q = set.quantity(j).value_or(0);
    if (q == 0)
      continue;
    const auto n = static_cast<std::uint64_t>(q);
    if (set.match) {
      const Enclosure &size = set.match->sizes[*place(*set.match, j)];
      for (std::uint64_t i = 0; i < n; ++i)
        take(j, size, std::nullopt);
      continue;
    }
    const ClassSizes sizes(set.classes[j], set.wanted.dimension, set.digits);
    for (std::uint64_t i = 0; i < n; ++i) {
      const Rational y = draws(j, i, q);
      take(j, sizes.at(y), sizes.exact(y));
    }
  }
}

std::string estimate_text(const IntegerBounds &n) {
  return n.known() ? to_string(n.lo) : to_string(n.lo) + " or " + to_string(n.hi);
}

std::string percent(const Real &share) {
  return rounded(share * 100, read_digits);
}

/// The volume of class j's particles, all of the median size, up to a constant.
Real median_volume(const GeneratedSet &set, std::size_t j) {
  const unsigned p = set.wanted.dimension - 1;
  return Real(Rational(set.counts.numbers[j])) *
         pow(median_power(set.classes[j], set.wanted.dimension), ratio(set.wanted.dimension, p));
}

/// The largest error of a class's share by volume, with particles of the median size: what the floors cost.
Real worst_error(const GeneratedSet &set) {
  Real total = 0, worst = 0;
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    total = total + median_volume(set, j);
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    Real error = median_volume(set, j) / total - set.classes[j].volume_fraction;
    if (compare(error, 0) == Order::less)
      error = Real(0) - error;
    if (compare(worst, error) == Order::less)
      worst = error;
  }
  return worst;
}

/// Columns as wide as their longest entry, all to the right.
template <std::size_t n>
std::string table(const std::vector<std::array<std::string, n>> &lines) {
  std::array<std::size_t, n> width{};
  for (const auto &line : lines)
    for (std::size_t i = 0; i < n; ++i)
      width[i] = std::max(width[i], line[i].size());
  std::string text;
  for (const auto &line : lines) {
    for (std::size_t i = 0; i < n; ++i)
      text += fmt::format("  {:>{}}", line[i], width[i]);
    text += "\n";
  }
  return text;
}

std::string class_table(const GeneratedSet &set) {
  std::vector<std::array<std::string, 7>> lines = {
      {"class", "from", "to", "volume [%]", "N'", "N", "number [%]"}};
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    const SizeClass &c = set.classes[j];
    const bool decided = set.counts.decided();
    lines.push_back({std::to_string(j + 1), rounded(c.lower.real, read_digits),
                     rounded(c.upper.real, read_digits), percent(c.volume_fraction),
                     estimate_text(set.counts.estimate[j]), decided ? to_string(set.counts.numbers[j]) : "?",
                     decided ? percent(Real(ratio(set.counts.numbers[j], set.counts.particles()))) : "?"});
  }
  return table(lines);
}

std::string match_table(const GeneratedSet &set) {
  const Match &m = *set.match;
  std::vector<std::array<std::string, 6>> lines = {
      {"class", "from", "to", "volume", "quantity", "size of a particle"}};
  for (std::size_t j = 0; j < m.gradation.classes(); ++j) {
    const std::optional<std::size_t> at = place(m, j);
    lines.push_back({std::to_string(j + 1), to_decimal(m.gradation.lower(j)),
                     to_decimal(m.gradation.upper(j)), to_decimal(m.gradation.mass(j)),
                     at ? to_string(m.q[*at]) : "0", at ? m.sizes[*at].text() : "-"});
  }
  return table(lines);
}

std::string sized(const Rational &size, const std::string &unit) {
  return rounded(Real(size), read_digits) + (unit.empty() ? "" : " " + unit);
}

/// What Eq. 8-9 give, in a line.
std::string count_line(const GeneratedSet &set) {
  const ClassCounts &c = set.counts;
  if (!c.decided())
    return "4096 bits do not decide every N': N is not known";
  std::string text = "N = " + to_string(c.particles()) + " (sum N' = " + to_string(c.estimated().lo) + ")";
  if (c.particles() < set.wanted.at_least)
    text += ", " + to_string(Integer(set.wanted.at_least - c.particles())) +
            " fewer than N_min: the floors of Eq. 9 lose them";
  return text;
}

} // namespace

std::optional<Integer> GeneratedSet::quantity(std::size_t j) const {
  if (!match)
    return counts.decided() ? std::optional(counts.numbers[j]) : std::nullopt;
  if (!match->complete)
    return std::nullopt;
  const std::optional<std::size_t> at = place(*match, j);
  return at ? match->q[*at] : Integer(0);
}

std::optional<Integer> GeneratedSet::particles() const {
  if (match)
    return match->complete ? std::optional(match->particles()) : std::nullopt;
  return counts.decided() ? std::optional(counts.particles()) : std::nullopt;
}

std::optional<bool> GeneratedSet::accessible() const {
  if (!at_most)
    return true;
  if (!match)
    return is_accessible(counts, wanted, *at_most);
  if (match->complete)
    return match->particles() <= *at_most;
  return match->lower_bound > *at_most ? std::optional(false) : std::nullopt;
}

void generated_json(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink) {
  std::string text = fmt::format(
      R"({{"schema":"mdm-generate-1","id":{},"unit":{},"method":"{}","dimension":"{}","classes":[)",
      json_string(set.id), set.unit.empty() ? "null" : json_string(set.unit), set.match ? "match" : "paper",
      set.wanted.dimension);
  for (std::size_t j = 0; j < set.classes.size(); ++j) {
    const Shown c = shown(set, j);
    const std::optional<Integer> q = set.quantity(j);
    text += fmt::format(
        R"({}{{"lower":{},"upper":{},"volume_fraction":{},"estimate":["{}","{}"],"quantity":{}}})",
        j == 0 ? "" : ",", pair(c.lower, set.digits), pair(c.upper, set.digits),
        pair(c.volume_fraction, set.digits), to_string(set.counts.estimate[j].lo),
        to_string(set.counts.estimate[j].hi), q ? "\"" + to_string(*q) + "\"" : "null");
  }
  const std::optional<Integer> n = set.particles();
  const std::optional<bool> accessible = set.at_most ? set.accessible() : std::nullopt;
  text += fmt::format(R"(],"particles":{},"accessible":{},"Cu":{},"Cc":{})",
                      n ? "\"" + to_string(*n) + "\"" : "null",
                      accessible ? (*accessible ? "true" : "false") : "null",
                      pair(uniformity(*set.curve), set.digits), pair(curvature(*set.curve), set.digits));
  if (set.table > 0) {
    text += R"(,"curve":[)";
    for (unsigned i = 0; i < set.table; ++i) {
      const Rational d = table_size(set, i);
      text += fmt::format(R"({}{{"size":{},"passing":{}}})", i == 0 ? "" : ",", pair(Real(d), set.digits),
                          pair(set.curve->passing(Surd(d)), set.digits));
    }
    text += "]";
  }
  text += R"(,"notes":[)";
  for (std::size_t i = 0; i < set.notes.size(); ++i)
    text += (i == 0 ? "" : ",") + json_string(set.notes[i]);
  text += R"(],"versions":)" + versions_json();
  if (draws) {
    text += R"(,"sizes":[)";
    bool first = true;
    for_each_size(set, *draws, [&](std::size_t, const Enclosure &size, const std::optional<Rational> &exact) {
      text += first ? "" : ",";
      first = false;
      text += exact ? "\"" + to_string(*exact) + "\"" : pair(size);
      if (text.size() > part) {
        sink(text);
        text.clear();
      }
    });
    text += "]";
  }
  sink(text + "}");
}

void generated_csv(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink) {
  std::string text;
  if (draws) {
    text = "class,size_lo,size_hi\n";
    for_each_size(set, *draws, [&](std::size_t j, const Enclosure &size, const std::optional<Rational> &) {
      text += std::to_string(j + 1) + "," + columns(size) + "\n";
      if (text.size() > part) {
        sink(text);
        text.clear();
      }
    });
  } else if (set.table > 0) {
    text = "size_lo,size_hi,passing_lo,passing_hi\n";
    for (unsigned i = 0; i < set.table; ++i) {
      const Rational d = table_size(set, i);
      text += columns(enclose(Real(d), set.digits)) + "," +
              columns(enclose(set.curve->passing(Surd(d)), set.digits)) + "\n";
    }
  } else {
    text = "class,lower_lo,lower_hi,upper_lo,upper_hi,volume_fraction_lo,volume_fraction_hi,quantity\n";
    for (std::size_t j = 0; j < set.classes.size(); ++j) {
      const Shown c = shown(set, j);
      const std::optional<Integer> q = set.quantity(j);
      text += fmt::format("{},{},{},{},{}\n", j + 1, columns(enclose(c.lower, set.digits)),
                          columns(enclose(c.upper, set.digits)),
                          columns(enclose(c.volume_fraction, set.digits)), q ? to_string(*q) : "");
    }
  }
  sink(text);
}

std::string generated_text(const GeneratedSet &set) {
  std::string text =
      fmt::format("{}, from {} to {}\n  {}\n  C_u = {}, C_c = {}\n", printable(set.id),
                  sized(set.curve->d_min(), set.unit), sized(set.curve->d_max(), set.unit), set.terms,
                  rounded(uniformity(*set.curve), read_digits), rounded(curvature(*set.curve), read_digits));
  text += "\n  by the paper (Eq. 6-10): " + count_line(set) + "\n";
  if (set.counts.decided())
    text += "  the floors cost up to " + percent(worst_error(set)) +
            " % of the volume in a class, with particles of its median size\n";
  text += class_table(set);
  if (set.match) {
    const Match &m = *set.match;
    text += fmt::format("\n  exact, bounds and volumes rounded to {} digits: ", set.match_digits);
    text += m.complete ? "N = " + to_string(m.particles()) + ", every class's volume exactly as below\n" +
                             match_table(set)
                       : "N is at least " + to_string(m.lower_bound) + "\n";
  }
  if (const std::optional<bool> accessible = set.at_most ? set.accessible() : std::nullopt)
    text +=
        fmt::format("\n  {}accessible with N_max = {}\n", *accessible ? "" : "not ", to_string(*set.at_most));
  if (set.table > 0) {
    std::vector<std::array<std::string, 2>> lines = {{"d", "h(d)"}};
    for (unsigned i = 0; i < set.table; ++i) {
      const Rational d = table_size(set, i);
      lines.push_back({rounded(Real(d), read_digits), rounded(set.curve->passing(Surd(d)), read_digits)});
    }
    text += "\n" + table(lines);
  }
  for (const std::string &note : set.notes)
    text += "  note: " + note + "\n";
  return text;
}

} // namespace mdm
