// The packings of Voivret, Delenne and Radjai: their numbers of discs, single deposits, tables and
// statements.

#include "packing/support.hpp"
#include "papers/deposit_line.hpp"
#include "papers/packing_figures.hpp"
#include "papers/packing_statements.hpp"
#include "papers/packing_tables.hpp"

#include <algorithm>

namespace packing_study_test {

using namespace mdm;
using packing_test::has;
using packing_test::refusal;

namespace {

DepositFacts facts_of(const Rational &fraction, std::uint64_t three = 1, std::uint64_t four = 8,
                      std::uint64_t five = 1) {
  DepositFacts f;
  f.discs = three + four + five;
  f.fraction = fraction;
  f.contacts = 2 * f.discs;
  f.coordination = {{3, three}, {4, four}, {5, five}};
  f.cells = {1, 8, 1, 0};
  return f;
}

const PackingTerms &few() {
  static const PackingTerms terms{300, 1000};
  return terms;
}

std::ptrdiff_t count(const std::string &text, char c) {
  return std::count(text.begin(), text.end(), c);
}

/// Packing fractions with geometric classes from s = 0.4 on, and regular ones before, of an independent
/// program: spans .05 .1 .4 .8; 0: left out.
PackingStudy measured() {
  PackingStudy study;
  const std::vector<Rational> spans = {ratio(5, 100), ratio(1, 10), ratio(4, 10), ratio(8, 10)};
  const int fractions[6][4] = {{8229, 8230, 8357, 8792}, {8223, 8238, 8283, 8600}, {8239, 8243, 8284, 8619},
                               {8213, 8237, 8295, 8529}, {8210, 8251, 8286, 8532}, {8225, 8233, 8277, 8517}};
  for (const Classing classing : {Classing::geometric, Classing::regular})
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        PackingPoint p{packed_shapes()[i], classing, spans[j], Integer(25000), {}};
        // c4 falls with the span, the others grow.
        p.deposits = {facts_of(ratio(fractions[i][j], 10000), 1 + j, 20 - 3 * j, 1 + j)};
        if (classing == Classing::regular && i == 1 && j == 3)
          p.deposits.clear();
        study.points.push_back(std::move(p));
      }
  study.equal = facts_of(ratio(9065, 10000));
  return study;
}

std::string holds(const PackingStudy &study, const std::string &part) {
  for (const Statement &s : packing_statements(study))
    if (has(s.statement, part))
      return name(s.holds);
  return "no such statement";
}

} // namespace

TEST_CASE("points of Figure 9 have the numbers of discs that another program counted") {
  const auto discs = [](const Shape &shape, Classing classing, int percent) {
    return *disc_count({shape, classing, ratio(percent, 100)}, {});
  };
  CHECK(discs({1, 1}, Classing::regular, 2) == 25000);
  CHECK(discs({2, 4}, Classing::regular, 10) == 27750);
  CHECK(discs({1, 3}, Classing::regular, 60) == 64444);
  CHECK(discs({1, 3}, Classing::regular, 70) == 100894);
  CHECK(discs({2, 4}, Classing::regular, 60) == 102189);
  CHECK(discs({4, 4}, Classing::regular, 97) == 33801);
  CHECK(discs({4, 2}, Classing::geometric, 80) == 89798);
  CHECK(discs({4, 4}, Classing::geometric, 90) == 45444);
  CHECK(discs({1, 3}, Classing::geometric, 97) == 28188);
  CHECK(discs({1, 1}, Classing::geometric, 97) == 24994);
}

TEST_CASE("seeds go through boxes of nine widths") {
  std::vector<Rational> factors;
  for (std::uint64_t seed = 1; seed <= 9; ++seed)
    factors.push_back(width_factor(seed));
  CHECK(factors == std::vector<Rational>{1, ratio(21, 20), ratio(19, 20), ratio(11, 10), ratio(9, 10),
                                         ratio(23, 20), ratio(17, 20), ratio(6, 5), ratio(4, 5)});
  CHECK(width_factor(10) == 1);
}

TEST_CASE("a deposit of the study is the one of its sizes in a box of that width") {
  const DepositQuestion question{{1, 1}, Classing::geometric, ratio(3, 10), DepositRule::lowest, 1};
  DepositOptions options;
  CHECK(deposited(question, few()) == deposit(drawn_discs(question, few()), options));
  DepositQuestion wider = question;
  wider.seed = 2;
  const Packing p = deposited(wider, few()), square = deposit(drawn_discs(wider, few()));
  CHECK(static_cast<double>(p.width) == Approx(1.05 * static_cast<double>(square.width)));
  CHECK(question.key() != wider.key());
}

TEST_CASE(
    "every disc of a deposit has two supports: the mean coordination is 4 - 2 (supports by the floor) / N") {
  for (const DepositRule rule : {DepositRule::lowest, DepositRule::drop}) {
    const DepositFacts f = deposit_facts({{3, 1}, Classing::regular, ratio(1, 10), rule, 1}, few());
    CHECK(f.outer_supports > 0);
    CHECK(f.contacts + f.outer_supports == 2 * f.discs);
    CHECK(mean_coordination(f.coordination) == 4 - ratio(2 * f.outer_supports, f.discs));
    CHECK(f.fraction.lo > ratio(7, 10));
    CHECK(f.fraction.hi < ratio(9, 10));
  }
}

TEST_CASE("too few discs for a packing fraction are an error that says what to do") {
  CHECK(has(refusal([] { equal_disc_facts({9, 1000}); }), "equal discs: the discs are too few"));
  CHECK(has(refusal([] { equal_disc_facts({9, 1000}); }), "--at-least"));
}

TEST_CASE("equal discs from the left fill the share of the triangular lattice, six contacts a disc") {
  const DepositFacts f = equal_disc_facts({2500, 0});
  CHECK(f.fraction.lo > ratio(906, 1000));
  CHECK(f.fraction.hi < ratio(907, 1000) + ratio(1, 1000));
  CHECK(mean_coordination(f.coordination) > ratio(57, 10));
}

TEST_CASE("mean and scatter of a point are enclosed") {
  PackingPoint p{{1, 1}, Classing::geometric, ratio(1, 10), Integer(10), {facts_of(0), facts_of(0)}};
  p.deposits[0].fraction = {ratio(1, 10), ratio(2, 10)};
  p.deposits[1].fraction = {ratio(5, 10), ratio(7, 10)};
  CHECK(p.mean().lo == ratio(3, 10));
  CHECK(p.mean().hi == ratio(45, 100));
  CHECK(p.scatter().lo == ratio(3, 10));
  CHECK(p.scatter().hi == ratio(6, 10));
  CHECK(p.coordination() == 4);
  CHECK(p.touching(4) == ratio(8, 10));
  CHECK(p.touching(6) == 0);
  CHECK(p.cells().quadrangles == 16);
  p.deposits.pop_back();
  CHECK(p.scatter().lo == 0);
}

TEST_CASE("a line of the journal is read as it was written") {
  const DepositQuestion question{{1, 3}, Classing::regular, ratio(1, 10), DepositRule::lowest, 3};
  const DepositFacts f =
      deposit_facts({{1, 1}, Classing::geometric, ratio(1, 10), DepositRule::lowest, 3}, few());
  const std::string line = deposit_line({question.key(), f});
  const KeptDeposit read = read_deposit_line(line);
  CHECK(read.key == question.key());
  CHECK(read.facts.discs == f.discs);
  CHECK(read.facts.fraction.lo == f.fraction.lo);
  CHECK(read.facts.fraction.hi == f.fraction.hi);
  CHECK(read.facts.coordination == f.coordination);
  CHECK(deposit_line(read) == line);
  CHECK(read_terms_line(terms_line(few().text())) == few().text());
  CHECK(few().text() != PackingTerms{}.text());
  for (const std::string bad :
       {"", "{}", "[]", "{\"terms\":[]}", "no JSON", "{\"deposit\":\"a\",\"discs\":\"-1\"}"}) {
    CHECK(has(refusal([&] { read_deposit_line(bad); }), "no line of a journal"));
    CHECK(has(refusal([&] { read_terms_line(bad); }), "no line of a journal"));
  }
  const auto changed = [&line](const std::string &what, const std::string &by) {
    std::string text = line;
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    text.replace(at, what.size(), by);
    return refusal([&] { read_deposit_line(text); });
  };
  CHECK(has(changed("\"discs\":\"", "\"discs\":\"x"), "no line"));
  CHECK(has(changed("[\"0.", "[\"1."), "no line"));
  CHECK(has(changed("\"cells\"", "\"cell\""), "no line"));
}

TEST_CASE("tables of packings have a row a thing and as many cells as their header") {
  PackingStudy study = measured();
  study.terms = few();
  const std::string points = figure9_table(study);
  CHECK(count(points, '\n') == 49);
  CHECK(count(points, ',') == 49 * count(points.substr(0, points.find('\n')), ','));
  CHECK(has(points, "\n1,1,geometric,0.1,25000,1,0.823,0.823,0,0,4,"));
  CHECK(has(points, "\n1,3,regular,0.8,25000,0,,,,,,,,,,,,,left out: more than 1000 discs\n"));
  const std::string deposits = deposits_table(study.points);
  CHECK(count(deposits, '\n') == 48);
  CHECK(count(deposits, ',') == 48 * count(deposits.substr(0, deposits.find('\n')), ','));
  const std::string gasket = gasket_table(ApollonianGasket::equal(), 100);
  CHECK(count(gasket, '\n') == 1 + 451);
  CHECK(has(gasket, "\n1,0,1,1,-0.57735"));
  const Packing p = deposited({{1, 1}, Classing::geometric, ratio(1, 10)}, few());
  CHECK(count(discs_table({{ratio(1, 10), p}}), '\n') == static_cast<std::ptrdiff_t>(p.discs.size()) + 1);
  CHECK(count(cells_table(p), '\n') == static_cast<std::ptrdiff_t>(packing_texture(p).cells.total()) + 1);
}

TEST_CASE("the paper's statements are judged by the deposits of the study") {
  const PackingStudy study = measured();
  CHECK(holds(study, "coordination number is about 4") == "holds");
  CHECK(holds(study, "square lattice") == "holds");
  CHECK(holds(study, "above 0.82") == "holds");
  CHECK(holds(study, "declines") == "does not");
  CHECK(holds(study, "triangular cells") == "holds");
  CHECK(holds(study, "close to 0.81") == "does not");
  CHECK(holds(study, "rises slowly") == "holds");
  CHECK(holds(study, "matters little") == "holds");
  CHECK(holds(study, "rises strongly") == "holds");
  CHECK(holds(study, "largest packing fraction at all s") == "holds in part");
  CHECK(holds(study, "rise faster than") == "holds");
  CHECK(holds(study, "not accessible") == "holds");
  CHECK(holds(study, "four contacts") == "holds");
  const std::string table = statements_table(packing_statements(study));
  CHECK(count(table, '\n') == 14);
  CHECK(has(table, "regular classes: at all spans but s = 0.05, s = 0.1"));
}

TEST_CASE("statements for which a study has no deposits are open, and others can be false") {
  PackingStudy study = measured();
  for (PackingPoint &p : study.points)
    p.deposits.assign(1, facts_of(ratio(8, 10), 4, 2, 4));
  study.equal = facts_of(ratio(8, 10));
  CHECK(holds(study, "square lattice") == "holds");
  CHECK(holds(study, "above 0.82") == "does not");
  CHECK(holds(study, "triangular cells") == "does not");
  CHECK(holds(study, "rises slowly") == "does not");
  CHECK(holds(study, "largest packing fraction at all s") == "does not");
  CHECK(holds(study, "rise faster than") == "does not");
  CHECK(holds(study, "not accessible") == "does not");
  CHECK(holds(study, "four contacts") == "does not");
  study.points.clear();
  for (const char *part :
       {"coordination number", "square lattice", "above 0.82", "declines", "close to 0.81", "rises slowly",
        "matters little", "rises strongly", "at all s", "rise faster than"})
    CHECK(holds(study, part) == "cannot be decided");
}

TEST_CASE("figures of packings have panels, and lines for every shape") {
  const Figure fractions = fraction_figure(measured());
  REQUIRE(fractions.panels.size() == 2);
  for (const Panel &panel : fractions.panels) {
    CHECK(panel.series.size() == 12);
    for (const Series &s : panel.series)
      for (const Point &p : s.points)
        CHECK_FALSE((p.y < panel.y.low || p.y > panel.y.high));
  }
  const Snapshot snapshot{ratio(1, 10), deposited({{1, 1}, Classing::geometric, ratio(1, 10)}, few())};
  const Figure regions = regions_figure(snapshot), two = snapshots_figure({snapshot, snapshot});
  CHECK(regions.panels.size() == 2);
  CHECK(two.panels.size() == 2);
  for (const Figure &figure : {regions, two})
    for (const Panel &panel : figure.panels)
      CHECK(figure.panel_height / panel.y.span() == Approx(figure.panel_width / panel.x.span()));
  const Packing gasket = ApollonianGasket::equal().packing(100);
  CHECK(has(gasket_figure(gasket, 100).title, "451 circles"));
}

} // namespace packing_study_test
