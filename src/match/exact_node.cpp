// A node of the search decided in exact numbers: the linear program of Theorem 12 with the bounds in force,
// t_j > f_j q_j strict where q_j >= 1, by a simplex method in fractions with an infinitesimal. Three
// answers: it has no solution, and the multiples of its contradiction are the leaf; or the least number of
// particles has masses that round to a match (Theorem 13); or some count is no whole number, or a class
// without a least count has particles whose bound should be strict, and is split there. With every count
// whole and every strict bound in force a solution is a match, so one of the three is always there.

#include "match/exact_node.hpp"

#include "match/leaf_sum.hpp"

namespace mdm {
namespace {

const Infinitesimal above_zero{0, 1};

Infinitesimal whole(const Integer &n) {
  return {Rational(n), 0};
}

/// Least integer v > x - 1 that is not x: x < v is the branch below, where x is no integer.
Integer next_integer(const Infinitesimal &x) {
  const Integer n = floor(x.value);
  return x.value == n && x.tiny < 0 ? n : Integer(n + 1);
}

bool is_integer(const Infinitesimal &x) {
  return x.tiny == 0 && denominator(x.value) == 1;
}

} // namespace

ExactNode::ExactNode(const TolerantProblem &problem, const Watch &watch)
    : problem_(problem), program_(problem.variables(), watch) {
  for (const LinearRow &row : problem.rows()) {
    const std::size_t form = program_.add_form(row.terms);
    row_of_.push_back({row.condition, row.j, 0});
    if (row.condition == TolerantCondition::above_lower)
      strict_.push_back(form);
    else
      program_.set_lower(
          form, row.condition == TolerantCondition::some_mass ? above_zero : Infinitesimal{row.constant, 0});
    if (row.condition == TolerantCondition::at_least)
      count_ = form;
  }
  for (std::size_t p = 2 * problem.classes(); p < problem.variables(); ++p)
    program_.set_lower(p, Infinitesimal{});
}

void ExactNode::set(std::size_t variable, const CountBound &bound) {
  program_.set_lower(variable, whole(bound.least));
  program_.set_upper(variable, bound.most ? Simplex::Bound(whole(*bound.most)) : std::nullopt);
}

bool ExactNode::find(const CountBounds &bounds, const std::optional<Integer> &most) {
  for (std::size_t j = 0; j < problem_.classes(); ++j) {
    set(j, bounds[j]);
    program_.set_lower(strict_[j], bounds[j].least >= 1 ? above_zero : Infinitesimal{});
  }
  program_.set_upper(count_, most ? Simplex::Bound(whole(*most)) : std::nullopt);
  if (!program_.find(count_))
    return false;
  program_.minimise(count_);
  return true;
}

TreeNode ExactNode::leaf() const {
  std::vector<Rational> multipliers;
  TreeNode node;
  const std::size_t k = problem_.classes();
  for (const Simplex::Term &term : program_.conflict()) {
    multipliers.push_back(term.multiplier);
    if (term.variable < k) {
      node.leaf.push_back({term.is_upper ? TolerantCondition::most_count : TolerantCondition::least_count,
                           term.variable, 0, term.variable});
    } else if (term.variable < problem_.variables()) {
      node.leaf.push_back({TolerantCondition::excess_sign, term.variable - 2 * k, 0});
    } else {
      Multiple row = row_of_[term.variable - problem_.variables()];
      if (term.is_upper)
        row.condition = TolerantCondition::fewer;
      node.leaf.push_back(row);
    }
  }
  set_multipliers(node, multipliers);
  return node;
}

std::vector<Rational> ExactNode::masses() const {
  return program_.concrete_values(problem_.classes(), 2 * problem_.classes());
}

std::pair<std::size_t, Integer> ExactNode::split() const {
  for (std::size_t j = problem_.classes(); j-- > 0;)
    if (!is_integer(program_.value(j)))
      return {j, next_integer(program_.value(j))};
  for (std::size_t j = problem_.classes(); j-- > 0;)
    if (program_.lower(j)->value < 1 && program_.value(j).value >= 1)
      return {j, 1};
  return {0, 0}; // whole counts with all their masses strictly inside are a match
}

} // namespace mdm
