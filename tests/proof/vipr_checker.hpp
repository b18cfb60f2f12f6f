#pragma once
/// \file
/// A checker of VIPR 1.0 files for the tests: every rule of the format's specification but `sol`, in plain
/// fractions.

#include <mdm/number/decimal.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace vipr_checker {

using mdm::Integer;
using mdm::Rational;

struct Constraint {
  std::map<std::size_t, Rational> terms;
  char sense = 'G';
  Rational rhs;
  std::set<std::size_t> assumptions;
};

class Checker {
public:
  explicit Checker(const std::string &text) : in_(text) {}

  /// Throws if the file is not a proof that the least objective is `claimed`.
  void check(const Rational &claimed) {
    problem("min");
    expect("RTP");
    expect("range");
    demand(number() == claimed && number() == claimed, "range");
    expect("SOL");
    demand(count() == 1, "one solution");
    word();
    check_solution(terms(count()), claimed);
    const Constraint last = proved();
    demand(last.sense == 'G' && last.terms == objective_ && last.rhs >= claimed,
           "the last line bounds the objective");
  }

  /// Throws if the file is not a proof that its problem has no solution.
  void check_infeasible() {
    problem("min");
    expect("RTP");
    expect("infeas");
    expect("SOL");
    demand(count() == 0, "no solution");
    const Constraint last = proved();
    demand(last.terms.empty() && (last.sense == 'G' ? last.rhs > 0 : last.rhs < 0),
           "the last line is a contradiction");
  }

  /// Throws if the file is not a proof that the greatest objective is at most `bound`.
  void check_at_most(const Rational &bound) {
    problem("max");
    expect("RTP");
    expect("range");
    expect("-inf");
    demand(number() == bound, "range");
    expect("SOL");
    demand(count() == 0, "no solution");
    const Constraint last = proved();
    demand(last.sense == 'L' && last.terms == objective_ && last.rhs <= bound,
           "the last line bounds the objective");
  }

  /// True if the values, 0 where there are none, satisfy the problem of the file.
  bool admits(const std::map<std::size_t, Rational> &x, const char *sense = "max") {
    problem(sense);
    for (const std::size_t i : integers_)
      if (const auto v = x.find(i); v != x.end() && denominator(v->second) != 1)
        return false;
    return std::all_of(all_.begin(), all_.end(), [&](const Constraint &c) { return satisfied(c, x); });
  }

private:
  static void demand(bool holds, const char *what) {
    if (!holds)
      throw std::runtime_error(what);
  }
  std::string word() {
    std::string w;
    demand(static_cast<bool>(in_ >> w), "end of file");
    return w;
  }
  void expect(const char *what) { demand(word() == what, what); }
  std::size_t count() { return std::stoul(word()); }
  Rational number() {
    const std::string w = word();
    const std::size_t slash = w.find('/');
    return slash == std::string::npos
               ? mdm::parse_decimal(w)
               : Rational(mdm::parse_decimal(w.substr(0, slash)) / mdm::parse_decimal(w.substr(slash + 1)));
  }
  void skip_comments() {
    while (in_.peek() == '%') {
      std::string line;
      std::getline(in_, line);
    }
  }

  void problem(const char *sense) {
    skip_comments();
    expect("VER");
    expect("1.0");
    expect("VAR");
    for (std::size_t i = count(); i > 0; --i)
      word();
    expect("INT");
    for (std::size_t i = count(); i > 0; --i)
      integers_.insert(count());
    expect("OBJ");
    expect(sense);
    objective_ = terms(count());
    expect("CON");
    const std::size_t constraints = count();
    count(); // bounds
    for (std::size_t i = 0; i < constraints; ++i)
      all_.push_back(constraint());
  }

  /// What the last derived line states.
  Constraint proved() {
    expect("DER");
    for (std::size_t left = count(); left > 0; --left)
      derivation();
    std::string rest;
    demand(!(in_ >> rest), "nothing after the end");
    demand(all_.back().assumptions.empty(), "the last line holds without assumptions");
    return all_.back();
  }

  std::map<std::size_t, Rational> terms(std::size_t k) {
    std::map<std::size_t, Rational> t;
    for (; k > 0; --k) {
      const std::size_t i = count();
      demand(t.emplace(i, number()).second, "an index twice");
    }
    return t;
  }

  Constraint constraint() {
    Constraint c;
    word();
    c.sense = word().at(0);
    demand(c.sense == 'G' || c.sense == 'L', "sense");
    c.rhs = number();
    const std::string k = word();
    c.terms = k == "OBJ" ? objective_ : terms(std::stoul(k));
    return c;
  }

  static bool satisfied(const Constraint &c, const std::map<std::size_t, Rational> &x) {
    Rational sum = 0;
    for (const auto &[i, a] : c.terms)
      if (const auto v = x.find(i); v != x.end())
        sum += a * v->second;
    return c.sense == 'G' ? sum >= c.rhs : sum <= c.rhs;
  }

  void check_solution(const std::map<std::size_t, Rational> &x, const Rational &claimed) const {
    Rational value = 0;
    for (const auto &[i, v] : x) {
      demand(denominator(v) == 1 || integers_.count(i) == 0, "an integer solution");
      if (const auto coefficient = objective_.find(i); coefficient != objective_.end())
        value += v * coefficient->second;
    }
    demand(value == claimed, "the solution's value");
    for (const Constraint &c : all_)
      demand(satisfied(c, x), "the solution satisfies every constraint");
  }

  /// A suitable linear combination.
  Constraint combination() {
    Constraint sum;
    bool up = true, down = true;
    for (const auto &[i, lambda] : terms(count())) {
      const Constraint &c = all_.at(i);
      const Rational direction = c.sense == 'G' ? lambda : Rational(-lambda);
      up = up && direction >= 0;
      down = down && direction <= 0;
      sum.rhs += lambda * c.rhs;
      for (const auto &[j, a] : c.terms)
        sum.terms[j] += lambda * a;
      sum.assumptions.insert(c.assumptions.begin(), c.assumptions.end());
    }
    demand(up || down, "a suitable combination");
    sum.sense = up ? 'G' : 'L';
    for (auto t = sum.terms.begin(); t != sum.terms.end();)
      t = t->second == 0 ? sum.terms.erase(t) : std::next(t);
    return sum;
  }

  void round(Constraint &c) const {
    for (const auto &[i, a] : c.terms)
      demand(denominator(a) == 1 && integers_.count(i) == 1, "rounding needs integers");
    c.rhs = Rational(c.sense == 'G' ? mdm::ceil(c.rhs) : mdm::floor(c.rhs));
  }

  static bool dominates(const Constraint &c, const Constraint &d) {
    if (c.terms.empty() && (c.sense == 'G' ? c.rhs > 0 : c.rhs < 0))
      return true;
    return c.sense == d.sense && c.terms == d.terms && (c.sense == 'G' ? c.rhs >= d.rhs : c.rhs <= d.rhs);
  }

  void derivation() {
    Constraint c = constraint();
    expect("{");
    const std::string rule = word();
    if (rule == "asm") {
      c.assumptions = {all_.size()};
    } else if (rule == "lin" || rule == "rnd") {
      Constraint derived = combination();
      if (rule == "rnd")
        round(derived);
      demand(dominates(derived, c), "the combination dominates");
      c.assumptions = derived.assumptions;
    } else if (rule == "uns") {
      const std::size_t i1 = count(), l1 = count(), i2 = count(), l2 = count();
      demand(dominates(all_.at(i1), c) && dominates(all_.at(i2), c), "both branches dominate");
      const Constraint &a = all_.at(l1), &b = all_.at(l2);
      const Constraint &low = a.sense == 'L' ? a : b, &high = a.sense == 'L' ? b : a;
      demand(low.sense == 'L' && high.sense == 'G' && low.terms == high.terms && high.rhs == low.rhs + 1 &&
                 denominator(low.rhs) == 1,
             "the branches are disjoint and cover");
      for (const auto &[i, x] : low.terms)
        demand(denominator(x) == 1 && integers_.count(i) == 1, "branching on integers");
      std::set<std::size_t> first = all_.at(i1).assumptions, second = all_.at(i2).assumptions;
      first.erase(l1);
      second.erase(l2);
      c.assumptions = first;
      c.assumptions.insert(second.begin(), second.end());
    } else {
      demand(false, "an unknown rule");
    }
    expect("}");
    word(); // last use
    all_.push_back(std::move(c));
  }

  std::istringstream in_;
  std::set<std::size_t> integers_;
  std::map<std::size_t, Rational> objective_;
  std::vector<Constraint> all_;
};

} // namespace vipr_checker
