#include "proof/question_text.hpp"

#include "proof/certificate_parts.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

using Kind = AskedTolerance::Kind;

/// The least percent that was asked for in this way; nothing if it was not.
std::optional<Rational> asked(const Question &q, Kind kind) {
  std::optional<Rational> least;
  for (const AskedTolerance &tolerance : q.tolerances)
    if (tolerance.kind == kind)
      least = std::min(least.value_or(tolerance.percent), tolerance.percent);
  return least;
}

/// The tolerances of `laboratory` and `rounding`: the least of each sieve, in percent.
std::vector<Rational> passing_each(const Question &q, const Gradation &g) {
  std::vector<Rational> least(g.classes() - 1, Rational(100));
  for (const Kind kind : {Kind::laboratory, Kind::rounding})
    if (asked(q, kind)) {
      const std::vector<Rational> percent = passing_tolerances(g, kind);
      for (std::size_t j = 0; j < least.size(); ++j)
        least[j] = std::min(least[j], percent[j]);
    }
  return least;
}

/// Writes the lines, and sees how long their numbers are.
class ToleranceWriter {
public:
  ToleranceWriter(const Question &question, const Gradation &g) : q_(question), g_(g) {}

  ToleranceLines lines() {
    add("retained", Kind::retained, Kind::retained_file);
    const bool one_class = g_.classes() == 1;
    const bool each = asked(q_, Kind::laboratory) || asked(q_, Kind::rounding);
    if (each && one_class) // nothing passes below the only sieve
      lines_.text += "passing 0\n";
    else
      add("passing", Kind::passing, Kind::passing_file);
    if (each && !one_class) {
      lines_.text += "passing-each";
      for (const Rational &percent : passing_each(q_, g_))
        lines_.text += " " + decimal(percent);
      lines_.text += "\n";
    }
    if (const std::optional<Rational> least = asked(q_, Kind::total))
      lines_.text += fmt::format("total {}\n", decimal(*least));
    if (q_.band)
      add_band(*q_.band);
    return lines_;
  }

private:
  void add(const char *name, Kind percent, Kind file) {
    if (const std::optional<Rational> least = asked(q_, percent))
      lines_.text += fmt::format("{} {}\n", name, decimal(*least));
    if (asked(q_, file))
      lines_.text += fmt::format("{} file\n", name);
  }

  void add_band(const Envelope &band) {
    lines_.bands = band.sizes.size();
    if (q_.band_alone) {
      lines_.text += "band file\n";
      return;
    }
    const Rational unit = in_mm(band.unit) / in_mm(g_.unit());
    for (std::size_t i = 0; i < band.sizes.size(); ++i)
      lines_.text += fmt::format("band {} {} {}\n", decimal(Rational(band.sizes[i] * unit)),
                                 decimal(band.passing_min[i]), decimal(band.passing_max[i]));
  }

  std::string decimal(const Rational &r) {
    lines_.longest = std::max(lines_.longest, longest_part(r));
    return to_decimal(r);
  }

  const Question &q_;
  const Gradation &g_;
  ToleranceLines lines_;
};

std::string law_line(const MassLaw &law) {
  if (law.is_power())
    return fmt::format("law {}\n", law.exponent());
  std::string text = law.sum.empty() ? "law table" : "law sum";
  for (const LawNode &node : law.table)
    text += fmt::format(" {} {}", to_decimal(node.size), to_decimal(node.mass));
  for (const LawTerm &term : law.sum)
    text += fmt::format(" {} {}", to_string(term.coefficient), term.exponent);
  return text + "\n";
}

} // namespace

std::string law_and_openings_lines(const Question &q) {
  std::string text = law_line(q.law);
  if (q.pan_size)
    text += fmt::format("pan-size {}\n", to_decimal(*q.pan_size));
  if (q.cut_below)
    text += fmt::format("cut-below {}\n", to_decimal(*q.cut_below));
  if (q.size_factor != 1)
    text += fmt::format("size-factor {}\n", to_decimal(q.size_factor));
  return text;
}

ToleranceLines tolerance_lines(const Question &question, const Gradation &g) {
  return ToleranceWriter(question, g).lines();
}

} // namespace mdm
