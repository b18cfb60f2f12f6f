#include "catch.hpp"
#include "match/brute_force.hpp"
#include "proof/vipr.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <sstream>

namespace tree_certificate_test {

using namespace mdm;

namespace {

using Kind = AskedTolerance::Kind;

mdm::checker::Verdict checked(const Gradation &g, const std::string &certificate) {
  return mdm::checker::check({"gradation", gradation_csv(g)}, {"certificate", certificate});
}

bool is_accepted(const Gradation &g, const std::string &certificate) {
  return checked(g, certificate).code == mdm::checker::Verdict::accepted;
}

int below(std::mt19937_64 &random, unsigned end) {
  return static_cast<int>(random() % end);
}

/// A small gradation with columns for all kinds of tolerance.
Gradation random_gradation(std::mt19937_64 &random) {
  const Gradation g = brute::random_gradation(random);
  Gradation::Data data{g.id(), g.unit(), g.sizes(), g.masses(), {}, {}, {}, {}};
  for (std::size_t j = 0; j < g.sizes().size(); ++j) {
    if (g.has_factors())
      data.factors.push_back(ratio(1 + below(random, 9), 4));
    data.tolerances.push_back(ratio(below(random, 80), 4));
    data.roundings.push_back(ratio(below(random, 20), 4));
  }
  return Gradation(std::move(data));
}

Envelope random_envelope(const Gradation &g, std::mt19937_64 &random) {
  Envelope e;
  e.unit = random() % 2 == 0 ? SizeUnit::um : SizeUnit::mm;
  for (std::size_t i = 0; i < g.sizes().size(); ++i) {
    if (random() % 3 == 0)
      continue;
    e.sizes.emplace_back(g.sizes()[i] / in_mm(e.unit));
    e.passing_min.emplace_back(i == 0 ? 0 : below(random, 60) / (random() % 2 == 0 ? 10 : 1));
    e.passing_max.push_back(std::min(Rational(100), Rational(e.passing_min.back() + 10 + below(random, 90))));
  }
  e.sizes.push_back(g.sizes().back() / in_mm(e.unit) + 1);
  e.passing_min.emplace_back(100);
  e.passing_max.emplace_back(100);
  return e;
}

/// A question with one tolerance or two, and other demands now and then.
Question random_question(const Gradation &g, std::mt19937_64 &random) {
  const Kind kinds[] = {Kind::retained,     Kind::passing,    Kind::total,   Kind::retained_file,
                        Kind::passing_file, Kind::laboratory, Kind::rounding};
  Question q;
  const std::size_t count = random() % 3;
  for (std::size_t i = 0; i < count; ++i)
    q.tolerances.push_back({kinds[random() % 7], ratio(below(random, 120), 4)});
  if (q.tolerances.empty())
    q.band = random_envelope(g, random);
  const MassLaw laws[] = {{3, 1}, {3, 1}, {1, 1}, {2, 1}};
  q.law = laws[random() % 4];
  if (random() % 4 == 0)
    q.min_per_class = 1 + below(random, 4);
  if (random() % 4 == 0)
    q.at_least = 1 + below(random, 20);
  if (random() % 4 == 0 && !q.band)
    q.size_factor = ratio(1 + below(random, 30), 10);
  if (random() % 4 == 0 && g.sizes().front() == 0)
    q.pan_size = g.sizes()[1] / 2;
  if (random() % 4 == 0 && g.mass(g.classes() - 1) > 0 && g.classes() > 1 && !q.band)
    q.cut_below = g.sizes()[1];
  if (!q.law.is_sphere())
    return q;
  switch (random() % 8) {
  case 0:
    q.solids = Cylinder{1 + below(random, 12), 1 + below(random, 12), ratio(7, 10)};
    break;
  case 1:
    q.solids = Box{1 + below(random, 12), 2, ratio(5, 2), ratio(1, 4)};
    break;
  case 2:
    q.solids = SolidsVolume{ratio(1 + below(random, 1000), 10)};
    break;
  default:
    break;
  }
  return q;
}

/// The text with the n-th word of the first line that begins so replaced.
std::string with_word(const std::string &text, const std::string &beginning, int n, const std::string &word) {
  const std::size_t begin = text.find("\n" + beginning) + 1;
  std::istringstream words(text.substr(begin, text.find('\n', begin) - begin));
  std::string line, old;
  for (int i = 0; words >> old; ++i)
    line += (i == 0 ? "" : " ") + (i == n ? word : old);
  return text.substr(0, begin) + line + text.substr(text.find('\n', begin));
}

std::string word_of(const std::string &text, const std::string &beginning, int n) {
  std::istringstream words(text.substr(text.find("\n" + beginning) + 1));
  std::string word;
  for (int i = 0; i <= n; ++i)
    words >> word;
  return word;
}

std::string one_more(const std::string &number) {
  return to_string(Integer(Integer(number) + 1));
}

/// Changes of an accepted certificate that leave nothing proved.
std::vector<std::string> tampered(const std::string &text, const Match &m) {
  std::vector<std::string> wrong = {with_word(text, "leaf", 1, one_more(word_of(text, "leaf", 1)))};
  if (!m.sample) {
    wrong.push_back(with_word(text, "particles", 1, "1"));
    return wrong;
  }
  wrong.push_back(with_word(text, "particles", 1, "none"));
  wrong.push_back(with_word(text, "particles", 1, one_more(word_of(text, "particles", 1))));
  if (m.particles() > 1)
    wrong.push_back(with_word(text, "particles", 1, to_string(Integer(*m.particles() - 1))));
  wrong.push_back(with_word(text, "class", 2, one_more(word_of(text, "class", 2))));
  const std::string mass = word_of(text, "class", 3);
  const std::size_t slash = mass.find('/');
  const Rational twice = slash == std::string::npos
                             ? Rational(Integer(mass) * 2)
                             : ratio(Integer(mass.substr(0, slash)) * 2, Integer(mass.substr(slash + 1)));
  wrong.push_back(with_word(text, "class", 3, to_string(twice)));
  wrong.push_back(with_word(text, "class", 4, to_decimal(m.gradation.lower(0))));
  return wrong;
}

} // namespace

TEST_CASE("the tree certificate of every question is accepted, and refused when it is tampered with") {
  std::mt19937_64 random(21);
  int none = 0, some = 0;
  for (int i = 0; i < 3000; ++i) {
    const Gradation g = random_gradation(random);
    const Question q = random_question(g, random);
    SolveOptions options;
    options.digits = 1 + static_cast<unsigned>(random() % 25);
    const Match m = solve(g, q, options);
    INFO(gradation_csv(g) << in_words(q, g.unit()));
    REQUIRE(m.complete);
    const std::string text = certificate(m);
    const mdm::checker::Verdict verdict = checked(g, text);
    INFO(text << verdict.line << verdict.reason);
    REQUIRE(verdict.code == mdm::checker::Verdict::accepted);
    ++(m.sample ? some : none);
    for (const std::string &wrong : tampered(text, m)) {
      INFO(wrong);
      REQUIRE_FALSE(is_accepted(g, wrong));
    }
  }
  CHECK(some >= 2300);
  CHECK(none >= 490);
}

TEST_CASE("a law that is rational at all openings has tree certificates") {
  Gradation::Data data;
  data.sizes = {1, 4, 9, ratio(49, 4)};
  data.masses = {2, 1, 3, 0};
  const Gradation g(std::move(data));
  Question q;
  q.law = {3, 2};
  q.tolerances = {parse_tolerance("retained:5%")};
  CHECK(is_accepted(g, certificate(solve(g, q))));
  q.law = {1, 2};
  CHECK(is_accepted(g, certificate(solve(g, q))));
}

TEST_CASE("a search that a limit ends has a certificate of its bounds, and no higher claim is accepted") {
  std::mt19937_64 random(22);
  int between = 0, below = 0, higher = 0;
  for (int i = 0; i < 6000; ++i) {
    const Gradation g = random_gradation(random);
    const Question q = random_question(g, random);
    SolveOptions options;
    if (random() % 8 == 0)
      options.limits.deadline = std::chrono::steady_clock::now();
    else
      options.limits.node_limit = random() % 4;
    const Match m = solve(g, q, options);
    if (m.complete)
      continue;
    INFO(gradation_csv(g) << in_words(q, g.unit()));
    const Match all = solve(g, q);
    REQUIRE(has_certificate(m) == (m.sample || m.lower_bound > 1));
    if (!has_certificate(m))
      continue;
    REQUIRE(m.proof.bound == m.lower_bound);
    REQUIRE((!all.sample || *m.proof.bound <= *all.particles()));
    const std::string text = certificate(m);
    const mdm::checker::Verdict verdict = checked(g, text);
    INFO(text << verdict.line << verdict.reason);
    REQUIRE(verdict.code == mdm::checker::Verdict::accepted);
    ++(m.sample ? between : below);
    if (!all.sample)
      continue;
    const std::string end = m.sample ? to_string(*m.particles()) : "";
    if (const Integer wrong = *all.particles() + 1; !m.sample || wrong < *m.particles()) {
      ++higher;
      REQUIRE_FALSE(is_accepted(g, with_word(text, "particles", 1, to_string(wrong) + ".." + end)));
    }
  }
  CHECK(between >= 200);
  CHECK(below >= 20);
  CHECK(higher >= 20);
}

namespace {

/// A lognormal curve of 24 classes.
Gradation curve_of_many_classes() {
  const char *const rows[][2] = {
      {"2.6265", "0"},       {"3.463", "0.0001"},  {"4.5658", "0.0004"},  {"6.0199", "0.0019"},
      {"7.937", "0.0077"},   {"10.465", "0.0277"}, {"13.797", "0.0878"},  {"18.191", "0.2473"},
      {"23.985", "0.6183"},  {"31.623", "1.3716"}, {"41.694", "2.7001"},  {"54.971", "4.717"},
      {"72.478", "7.3131"},  {"95.56", "10.0613"}, {"125.99", "12.2843"}, {"166.12", "13.31"},
      {"219.02", "12.7977"}, {"288.77", "10.92"},  {"380.73", "8.2689"},  {"501.98", "5.5566"},
      {"661.84", "3.3135"},  {"872.62", "1.7536"}, {"1150.5", "0.8235"},  {"1516.9", "0.3432"},
      {"2000", "0"}};
  Gradation::Data data;
  for (const auto &[size, mass] : rows) {
    data.sizes.push_back(parse_decimal(size));
    data.masses.push_back(parse_decimal(mass));
  }
  return Gradation(std::move(data));
}

} // namespace

TEST_CASE("a proof by windows of the mass is accepted in version 3, and what does not have that refuses it") {
  const Gradation g = curve_of_many_classes();
  Question q;
  q.tolerances = {{Kind::retained, 1}};
  const Match m = solve(g, q);
  REQUIRE(m.complete);
  const std::string text = certificate(m);
  CHECK(text.starts_with("mdm-certificate 3\n"));
  CHECK(text.find("\nwindow ") != std::string::npos);
  CHECK(is_accepted(g, text));
  CHECK_FALSE(is_accepted(g, with_word(text, "particles", 1, one_more(to_string(*m.particles())))));
  CHECK_THROWS_AS(vipr(m), InputError);
}

TEST_CASE("a search by windows that a limit ends proves what is certain") {
  const Gradation g = curve_of_many_classes();
  Question q;
  q.tolerances = {{Kind::retained, 1}};
  SolveOptions options;
  options.limits.node_limit = 4;
  const Match m = solve(g, q, options);
  REQUIRE_FALSE(m.complete);
  const std::string text = certificate(m);
  CHECK(is_accepted(g, text));
  const std::string higher = to_string(Integer(m.lower_bound + 1)) + ".." + to_string(*m.particles());
  CHECK_FALSE(is_accepted(g, with_word(text, "particles", 1, higher)));
}

namespace {

/// The same proof, with every window cut into many that its leaf refutes one by one.
Tree cut_up(const Tree &tree) {
  constexpr int cuts = 10;
  Tree longer;
  for (const TreeNode &node : tree) {
    for (int i = 1; i <= cuts && node.is_window; ++i) {
      TreeNode cut;
      cut.mass = Rational(i);
      longer.push_back(cut);
      longer.push_back(node);
    }
    longer.push_back(node);
  }
  return longer;
}

/// The same match, with masses that are fractions of 50,000 bits.
void lengthen_masses(MatchSample &sample) {
  const Rational little = ratio(1, Integer(Integer(1) << 50000));
  std::vector<Rational> &shares = *sample.shares;
  std::vector<std::size_t> holding;
  for (std::size_t j = 0; j < shares.size(); ++j)
    if (sample.quantities[j] > 0)
      holding.push_back(j);
  shares[holding[holding.size() / 2]] += little;
  shares[holding[holding.size() / 2 + 1]] -= little;
}

} // namespace

TEST_CASE("where a proof is beyond the limits of the format, less is proved, down to what was asked for") {
  const Gradation g = curve_of_many_classes();
  Question q;
  q.tolerances = {{Kind::retained, 1}};
  Match m = solve(g, q);
  REQUIRE(m.complete);
  const Integer n = *m.particles();
  lengthen_masses(*m.sample);
  CHECK_FALSE(certified(m).bound.has_value());
  CHECK(is_accepted(g, certificate(m)));

  Match with_cuts = m;
  with_cuts.proof.evidence = cut_up(std::get<Tree>(*m.evidence()));
  const Certified all = certified(with_cuts);
  CHECK_FALSE(all.bound.has_value());
  CHECK(is_accepted(g, all.text));
  CHECK_FALSE(is_accepted(g, with_word(all.text, "particles", 1, to_string(Integer(n + 1)))));

  with_cuts.complete = false;
  with_cuts.proof.bound = n - 1;
  const Certified less = certified(with_cuts);
  REQUIRE(less.bound.has_value());
  CHECK(*less.bound == n - 1);
  CHECK(is_accepted(g, less.text));
  CHECK_FALSE(
      is_accepted(g, with_word(less.text, "particles", 1, to_string(Integer(n + 1)) + ".." + to_string(n))));

  Match without = m;
  without.proof.evidence.reset();
  const Certified asked = certified(without);
  REQUIRE(asked.bound.has_value());
  CHECK(*asked.bound == 1);
  CHECK(is_accepted(g, asked.text));
  CHECK_FALSE(is_accepted(g, with_word(asked.text, "particles", 1, "2.." + to_string(n))));
}

} // namespace tree_certificate_test
