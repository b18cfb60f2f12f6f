#include "papers/accessible_shapes.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

void add_paper(AccessibleRow &row, const AccessibleQuestion &question, const BetaCurve &curve,
               const std::vector<SizeClass> &classes) {
  try {
    const ClassCounts counts = class_counts(classes, curve, question.wanted);
    row.paper_accessible = is_accessible(counts, question.wanted, question.at_most);
    if (counts.decided())
      row.paper = std::max(counts.estimated().lo, question.wanted.at_least);
    else
      row.why = "4096 bits do not decide every N'";
  } catch (const TooManyParticles &e) {
    row.paper_accessible = false;
    row.why = e.what();
  }
}

void add_match(AccessibleRow &row, const AccessibleQuestion &question,
               const std::vector<SizeClass> &classes) {
  SolveOptions options;
  if (question.time_limit)
    options.limits.deadline = std::chrono::steady_clock::now() + *question.time_limit;
  const Match m =
      matched_set(rounded_gradation(classes, question.match_digits, ""), question.wanted, options);
  if (m.complete) {
    row.match = m.particles();
    row.match_accessible = *row.match <= question.at_most;
  } else {
    row.why = "the time limit came before the smallest match";
    if (m.lower_bound > question.at_most)
      row.match_accessible = false;
  }
}

} // namespace

std::vector<AccessibleRow> grid(const AccessibleQuestion &question) {
  std::vector<AccessibleRow> rows;
  for (const Rational &span : question.spans)
    for (const Rational &a : question.a)
      for (const Rational &b : question.b) {
        AccessibleRow row;
        row.span = span;
        row.shape = {a, b};
        rows.push_back(std::move(row));
      }
  return rows;
}

void fill(AccessibleRow &row, const AccessibleQuestion &question) {
  try {
    const BetaCurve curve = spanned_curve(row.shape, row.span);
    row.c_u = uniformity(curve);
    row.c_c = curvature(curve);
    const std::vector<SizeClass> classes = size_classes(curve, question.classing, question.classes);
    add_paper(row, question, curve, classes);
    add_match(row, question, classes);
  } catch (const InputError &e) {
    row.why = e.what();
  }
}

} // namespace mdm
