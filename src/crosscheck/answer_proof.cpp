#include "crosscheck/answer_proof.hpp"

#include "gradation/size_range.hpp"
#include "particles/sample_certifier.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// Particles of a class, and the sizes that each may have.
struct RangedClass {
  std::size_t j;
  Integer quantity;
  SizeRange size;
};

/// The sizes of class j within the tolerance of one that is stated; where none is in the class, those
/// outside.
SizeRange allowed_sizes(const Gradation &g, std::size_t j, const std::optional<StatedSize> &stated,
                        const Rational &unit, const Rational &size_tolerance) {
  const Rational &lower = g.lower(j), &upper = g.upper(j);
  if (!stated)
    return {lower, upper, true};
  const Rational lo = stated->lo * unit * (1 - size_tolerance), hi = stated->hi * unit * (1 + size_tolerance);
  if (hi <= lower || lo > upper)
    return {lo, hi};
  SizeRange range{std::max(lo, lower), std::min(hi, upper), lo <= lower};
  range.is_open = range.is_open && range.lo < range.hi;
  return range;
}

/// The particles by class; none where the answer has not an entry for each class, or for each with mass.
std::vector<RangedClass> ranged_classes(const Gradation &g, const OtherAnswer &answer,
                                        const Rational &size_tolerance) {
  std::vector<std::size_t> entries; // the class of each
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (answer.quantities.size() == g.classes() || g.mass(j) != 0)
      entries.push_back(j);
  std::vector<RangedClass> classes;
  if (entries.size() != answer.quantities.size() ||
      (!answer.sizes.empty() && answer.sizes.size() != entries.size()))
    return classes;
  const Rational unit = answer.unit_mm / in_mm(g.unit());
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (answer.quantities[i] > 0)
      classes.push_back({entries[i], answer.quantities[i],
                         allowed_sizes(g, entries[i], answer.sizes.empty() ? std::nullopt : answer.sizes[i],
                                       unit, size_tolerance)});
  return classes;
}

/// A scale at which every class with mass has its mass with sizes that are allowed; nothing if there is none.
std::optional<Rational> common_scale(const Gradation &g, unsigned a,
                                     const std::vector<RangedClass> &classes) {
  std::optional<Rational> from, to;
  bool is_open = false; // below
  std::size_t with_mass = 0;
  for (std::size_t j = 0; j < g.classes(); ++j)
    with_mass += g.mass(j) != 0 ? 1U : 0U;
  for (const RangedClass &c : classes) {
    if (g.mass(c.j) == 0)
      return std::nullopt;
    const Rational unit = c.quantity * g.factor(c.j) / g.mass(c.j);
    const Rational lo = unit * power(c.size.lo, a), hi = unit * power(c.size.hi, a);
    if (!from || lo > *from || (lo == *from && c.size.is_open)) {
      from = lo;
      is_open = c.size.is_open;
    }
    to = std::min(to.value_or(hi), hi);
  }
  if (classes.size() != with_mass || *from > *to || (*from == *to && is_open))
    return std::nullopt;
  return (*from + *to) / 2;
}

std::optional<AnswerProof> proof_of(SampleCertifier &certifier, const std::string &sample) {
  const std::optional<CertifiedSample> made = certifier.certified();
  return made ? std::optional(AnswerProof{sample, made->text}) : std::nullopt;
}

} // namespace

std::optional<AnswerProof> answer_proof(const Gradation &g, const Question &question,
                                        const OtherAnswer &answer, const Rational &size_tolerance) {
  const std::vector<RangedClass> classes = ranged_classes(g, answer, size_tolerance);
  if (answer.failure || classes.empty() || !question.law.is_power())
    return std::nullopt;
  std::string sample;
  const SampleCertifier::Begin begin = [&sample] {
    sample.clear();
    return Sink([&sample](std::string_view text) { sample += text; });
  };
  SampleCertifier of_ranges(g, question, begin);
  for (const RangedClass &c : classes)
    of_ranges.add(c.size, c.quantity);
  if (std::optional<AnswerProof> proof = proof_of(of_ranges, sample))
    return proof;
  const unsigned a = question.law.a, b = question.law.b;
  const std::optional<Rational> s =
      question.is_tolerant() || b > 1 ? std::nullopt : common_scale(g, a, classes);
  if (!s)
    return std::nullopt;
  SampleCertifier of_scale(g, question, begin);
  for (const RangedClass &c : classes) {
    const Rational powered = *s * g.mass(c.j) / (g.factor(c.j) * c.quantity); // x^a
    of_scale.add(a > 1 ? RootSize{powered, a} : RootSize{power(powered, 2), 2}, c.quantity);
  }
  return proof_of(of_scale, sample);
}

} // namespace mdm
