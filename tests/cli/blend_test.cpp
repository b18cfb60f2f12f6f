// mdm blend as a whole program.

#include "answer.hpp"

#include <chrono>
#include <csignal>
#include <thread>

namespace blend_test {

using namespace cli_test;

namespace {

/// Two stockpiles and limits: at 4 mm 100 and 40 percent pass, at 1 mm 60 and 0.
class Stockpiles {
public:
  explicit Stockpiles(const std::string &limits = "4,60,70\n1,10,30\n") {
    folder_.write("fine.csv", "size_mm,passing_percent\n8,100\n4,100\n1,60\n0.5,0\n");
    folder_.write("coarse.csv", "size_mm,passing_percent\n8,100\n4,40\n2,0\n");
    folder_.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n" + limits);
  }

  Outcome blend(const Arguments &options = {}) const {
    Arguments all{"blend", folder_ / "fine.csv", folder_ / "coarse.csv", "--spec", folder_ / "limits.csv"};
    all.insert(all.end(), options.begin(), options.end());
    return mdm(all);
  }
  Json json(Arguments options, int exit_code = 0) const {
    options.insert(options.end(), {"--format", "json"});
    const Outcome outcome = blend(options);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == exit_code);
    return Json::parse(outcome.out);
  }
  const TemporaryFolder &folder() const { return folder_; }

private:
  TemporaryFolder folder_;
};

std::vector<Rational> shares(const Json &blend) {
  std::vector<Rational> all;
  for (const Json &share : blend.at("shares"))
    all.push_back(rational(share));
  return all;
}

} // namespace

TEST_CASE("a blend as text: shares, sieves, slack, prices, and what rounding would break", "[cli]") {
  // 40 + 60 f >= 60, so f >= 1/3; the cost falls with f.
  const Outcome outcome = Stockpiles().blend({"--cost", "fine=10,coarse=4"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out == "34 % fine, 66 % coarse: within limits\n"
                       "  cost: 6.04, the least in steps of 1 %\n\n"
                       "  stockpile  share (%)  cost  real optimum (%)  rounded (%)\n"
                       "  fine              34    10           33.3333           33\n"
                       "  coarse            66     4           66.6666           67\n\n"
                       "  sieve (mm)  at least  passing  at most  slack  price of a point\n"
                       "           4        60     60.4       70    0.4               0.1\n"
                       "           1        10     20.4       30    9.6                 -\n\n"
                       "  of any real shares the least is 6\n"
                       "  rounded to steps the real optimum breaks 1 limit: at least 60 % passing 4 mm\n");
}

TEST_CASE("without blends the limits that contradict each other are told, exit 1", "[cli]") {
  const Outcome outcome = Stockpiles("4,60,70\n1,0,10\n").blend();
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.out, "no blend of these 2 stockpiles keeps the limits of limits\n"));
  CHECK(contains(
      outcome.out,
      "the stockpiles cannot have at least 60 % passing 4 mm and at most 10 % passing 1 mm together:\n"
      "    1 x (at least 60 % passing 4 mm)\n"
      "    1 x (at most 10 % passing 1 mm)\n"
      "    -40 x (shares sum to 1)\n"
      "  add up to 0 >= 10"));
  CHECK(contains(outcome.out,
                 "all limits of sieves must be widened by 5 points for a blend: 25 % fine, 75 % coarse"));
  const Outcome one = Stockpiles("4,60,70\n1,0,10\n").blend({"--relax", "4mm"});
  CHECK(
      contains(one.out, "the limits at 4 mm alone must be widened by 10 points for a blend: 16.6666 % fine"));
  CHECK(contains(one.out, "in steps of 1 % by 10.4 points: 16 % fine"));
}

TEST_CASE("where real shares keep limits that none in steps keep, that is told", "[cli]") {
  const Stockpiles stockpiles("4,60,60.1\n1,0,100\n");
  const Json none = stockpiles.json({}, 1);
  CHECK(none.at("status") == "none");
  CHECK(none.at("contradiction").is_null());
  CHECK(none.at("real").is_object());
  CHECK(none.at("widened").at("value") == "1/5"); // 33 %: 59.8
  CHECK(contains(
      stockpiles.blend().out,
      "no blend of these 2 stockpiles keeps the limits of limits in steps of 1 %\n"
      "  real shares keep all limits: 33.3333 % fine, 66.6666 % coarse\n"
      "  in steps of 1 % all limits of sieves must be widened by 0.2 points: 33 % fine, 67 % coarse\n"));
  CHECK(contains(stockpiles.blend({"--share", "fine=33.4%"}).out,
                 "  real shares keep all limits: 33.4 % fine, 66.6 % coarse\n"
                 "  no widening of all limits of sieves leaves a blend in steps of 1 %\n"));
  CHECK(stockpiles.json({"--step", "1kg of 3kg"}).at("status") == "optimal");
}

TEST_CASE("steps may have exponents, and masses no unit", "[cli]") {
  const Stockpiles stockpiles;
  for (const char *step : {"1e-1%", "1e-1 %", "1e-1", "1E-1", "0.1"})
    CHECK(contains(stockpiles.blend({"--step", step}).out, "in steps of 0.1 %"));
  CHECK(contains(stockpiles.blend({"--step", "5e-1kg of 1e3kg"}).out, "in steps of 0.5 kg of 1000 kg"));
  const std::string bare = stockpiles.blend({"--step", "5 of 1000"}).out;
  CHECK(contains(bare, "in steps of 5 of 1000"));
  CHECK(contains(bare, "share (%)  mass"));
  CHECK_FALSE(contains(bare, "mass ()"));
}

TEST_CASE("shares of more stockpiles than asked for are told as such", "[cli]") {
  const std::string none = Stockpiles().blend({"--at-most-stockpiles", "1"}).out;
  CHECK(contains(none, "no blend of at most 1 of these 2 stockpiles keeps the limits"));
  CHECK(contains(none, "  real shares of any number of stockpiles keep all limits: "));
}

TEST_CASE("sieves of stockpiles that a blend's gradation lacks are named", "[cli]") {
  const TemporaryFolder folder;
  const std::string a = folder.write("a.csv", "size_mm,passing_percent\n20,100\n10,50\n1,0\n"),
                    b = folder.write("b.csv", "size_mm,passing_percent\n5,100\n0.5,10\n0.1,0\n"),
                    limits = folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n"
                                                        "20,100,100\n4,40,55\n0.3,0,10\n");
  const Outcome blended = mdm({"blend", a, b, "--spec", limits, "--blended", folder / "m.csv"});
  CHECK(blended.exit_code == 0);
  CHECK(contains(blended.err, "Left out of the blend's gradation are sieves at which a stockpile is "
                              "interpolated, or not known: 1, 5 mm."));
}

TEST_CASE("all blends in steps, in their order", "[cli]") {
  const Json all = Stockpiles("4,52,70\n1,0,30\n").json({"--step", "5%", "--all", "100"});
  CHECK(all.at("all") == true);
  std::vector<Rational> fine;
  for (const Json &blend : all.at("blends"))
    fine.push_back(shares(blend).at(0));
  CHECK(fine == std::vector<Rational>{Rational(1, 5), Rational(1, 4), Rational(3, 10), Rational(7, 20),
                                      Rational(2, 5), Rational(9, 20), Rational(1, 2)});
  const Json two = Stockpiles("4,52,70\n1,0,30\n").json({"--step", "5", "--all", "2"});
  CHECK(two.at("blends").size() == 2);
  CHECK(two.at("all") == false);
}

TEST_CASE("limits of shares, targets, and the number of stockpiles", "[cli]") {
  const Stockpiles stockpiles;
  CHECK(shares(stockpiles.json({"--share", "fine=45..60%"}).at("blends").at(0)).at(0) == Rational(45, 100));
  CHECK(shares(stockpiles.json({"--share", "coarse=55%"}).at("blends").at(0)).at(1) == Rational(55, 100));
  CHECK(stockpiles.json({"--share", "fine=..20%"}, 1).at("contradiction").at("limits").size() == 2);
  CHECK(stockpiles.json({"--at-most-stockpiles", "1"}, 1).at("contradiction").is_null());
  const std::string curve =
      stockpiles.folder().write("curve.csv", "size_mm,passing_percent\n8,100\n4,65\n1,20\n0.5,0\n");
  const Json sum = stockpiles.json({"--target", curve});
  CHECK(sum.at("aim") == "deviation");
  // 60 f - 25 and 60 f - 20: together least from f = 1/3 to 5/12, 5 points.
  CHECK(sum.at("blends").at(0).at("value") == "5");
  CHECK(shares(sum.at("blends").at(0)).at(0) == Rational(34, 100));
  const Json largest = stockpiles.json({"--target", curve, "--minimise", "max-deviation"});
  CHECK(largest.at("real").at("value") == "5/2"); // f = 3/8
  CHECK(largest.at("blends").at(0).at("value") ==
        "14/5"); // f = 37/100 or 38/100: |22.2 - 25| and |22.8 - 20|
  CHECK(shares(largest.at("blends").at(0)).at(0) == Rational(37, 100));
}

TEST_CASE("a target may be a computed curve, which a note and the proof say in numbers", "[cli]") {
  const Stockpiles stockpiles("4,60,70\n1,10,30\n16,100,100\n");
  const std::string proof = stockpiles.folder() / "proof", limits = stockpiles.folder() / "limits.csv",
                    fine = stockpiles.folder() / "fine.csv", coarse = stockpiles.folder() / "coarse.csv";
  const Json best = stockpiles.json({"--target", "fuller:16mm", "--proof", proof});
  CHECK(best.at("blends").at(0).at("value") == "15"); // |40 + 60 f - 50| + |60 f - 25| for f from 1/3 to 5/12
  CHECK(shares(best.at("blends").at(0)).at(0) == Rational(34, 100));
  CHECK(best.at("notes").dump().find("computed and rounded to 9 decimals") != std::string::npos);
  const Outcome checked = mdm_check({limits, fine, coarse, proof});
  INFO(checked.err);
  CHECK(checked.exit_code == 0);
  check_refused(stockpiles.blend({"--target", "fuller:0"}), "--target: 'fuller:0'");
  check_refused(stockpiles.blend({"--target", "fuller"}), "fuller");
}

TEST_CASE("the gradation of a blend is a file that other commands read", "[cli]") {
  const Stockpiles stockpiles;
  const std::string mix = stockpiles.folder() / "mix.csv";
  const Outcome outcome = stockpiles.blend({"--step", "5kg of 100kg", "--blended", mix});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "steps of 5 kg of 100 kg"));
  // 35 % fine: at 8, 4, 2 (fine: interpolated, so no sieve), 1 and 0.5 mm pass 100, 61, -, 21 and 0 percent.
  CHECK(read_file(mix) == "size_mm,mass\n0.5,21\n1,40\n4,39\n8,0\n");
  CHECK(mdm({"solve", mix}).exit_code == 0);
  const std::string json = stockpiles.folder() / "mix.json";
  CHECK(stockpiles.blend({"--blended", json}).exit_code == 0);
  CHECK(Json::parse(read_file(json)).at("sizes").size() == 4);
}

TEST_CASE("with densities the gradation of a blend keeps the stockpiles as materials", "[cli]") {
  const Stockpiles stockpiles;
  const std::string blended = stockpiles.folder() / "blended.csv", proof = stockpiles.folder() / "proof";
  REQUIRE(stockpiles.blend({"--blended", blended, "--density", "fine=2.65,coarse=2.5"}).exit_code == 0);
  // 34 percent are fine: 40 % of it from 0.5 to 1 mm... each class keeps its part of 100.
  CHECK(read_file(blended) == "size_mm,mass,factor,material\n"
                              "2,26.4,2.5,coarse\n4,39.6,2.5,coarse\n8,0,2.5,coarse\n"
                              "0.5,20.4,2.65,fine\n1,13.6,2.65,fine\n4,0,2.65,fine\n8,0,2.65,fine\n");
  const Outcome solved = mdm({"solve", blended, "--tolerance", "1%", "--proof", proof});
  CHECK(solved.exit_code == 0);
  CHECK(mdm_check({blended, proof}).exit_code == 0);
  check_refused(stockpiles.blend({"--density", "fine=2.65,coarse=2.5"}), "give it such a file");
  check_refused(stockpiles.blend({"--blended", blended, "--density", "fine=2.65"}),
                "the density of 'coarse' is missing: add coarse=VALUE");
  check_refused(stockpiles.blend({"--blended", blended, "--density", "fine=0,coarse=1"}), "--density");
  check_refused(
      stockpiles.blend({"--blended", stockpiles.folder() / "b.json", "--density", "fine=1,coarse=1"}),
      "are in CSV");
}

TEST_CASE("blends as CSV have a row each, and notes on standard error", "[cli]") {
  const Stockpiles stockpiles("4,52,70\n3,0,90\n");
  const Outcome outcome = stockpiles.blend({"--step", "20%", "--all", "9", "--format", "csv"});
  CHECK(outcome.out == "rank,value,fine percent,coarse percent\n1,0,20,80\n2,0,40,60\n");
  CHECK(contains(outcome.err, "what passes 3 mm is interpolated between its sieves, linear in size"));
}

TEST_CASE("a limit of the search is exit 3", "[cli]") {
  const Outcome outcome = Stockpiles().blend({"--cost", "fine=10,coarse=4", "--node-limit", "0"});
  CHECK(outcome.exit_code == 3);
  CHECK(contains(outcome.out, "the search ended before a blend"));
}

TEST_CASE("the rounded real optimum is a blend where a limit comes first and it keeps all limits", "[cli]") {
  const Stockpiles stockpiles("4,60.2,70\n1,10,30\n");
  const std::string blended = stockpiles.folder() / "blended.csv";
  const Outcome outcome =
      stockpiles.blend({"--cost", "fine=10,coarse=4", "--node-limit", "0", "--blended", blended});
  CHECK(outcome.exit_code == 3);
  CHECK(contains(outcome.out, "34 % fine, 66 % coarse: within "));
  CHECK(contains(outcome.out, "the search ended before all were seen, and none has less than 6.02"));
  CHECK(std::filesystem::exists(blended));
  const Json none = stockpiles.json({"--cost", "fine=10,coarse=4", "--node-limit", "0"}, 3);
  CHECK(none.at("status") == "feasible");
  CHECK(Stockpiles().json({"--cost", "fine=10,coarse=4", "--node-limit", "0"}, 3).at("status") == "unknown");
}

TEST_CASE("what is wrong with a question of blends is refused", "[cli]") {
  const Stockpiles stockpiles;
  const auto refuses = [&stockpiles](const Arguments &options, const std::string &why) {
    check_refused(stockpiles.blend(options), why);
  };
  refuses({"--cost", "fine=1"}, "--cost: the cost of 'coarse' is missing: add coarse=VALUE");
  refuses({"--cost", "fine=1,coarse=2,fine=3"}, "--cost: 'fine' has two values");
  refuses({"--cost", "fine=-1,coarse=2"}, "--cost");
  refuses({"--cost", "sand=1"}, "--cost: there is no stockpile 'sand'; there are 'fine', 'coarse'");
  refuses({"--cost", "12"}, "--cost: '12' is no value of a stockpile: write NAME=VALUE");
  refuses({"--share", "fine=.."}, "limits nothing");
  refuses({"--share", "fine=40..30%"}, "no share of fine is from 40 to 30 %");
  refuses({"--share", "fine=40..130%"}, "--share");
  refuses({"--step", "0"}, "--step");
  refuses({"--step", "3%"}, "--step: '3%': the whole is 33.3333 steps");
  refuses({"--step", "5kg"}, "--step: '5kg' is no step");
  refuses({"--step", "5kg of 1000g"}, "--step: '5kg of 1000g' is no step");
  refuses({"--minimise", "price"},
          "--minimise: 'price' is none of cost, deviation, max-deviation, squares and none");
  refuses({"--minimise", "cost"}, "--minimise cost: it needs --cost");
  refuses({"--minimise", "deviation"}, "--minimise deviation: it needs --target");
  refuses({"--relax", "3mm"}, "--relax: '3mm' is no sieve with limits; there are 1, 4 mm");
  refuses({"--all", "0"}, "--all");
  refuses({"--at-most-stockpiles", "0"}, "--at-most-stockpiles");
  refuses({"--blended", "-"}, "--blended needs a file");
  refuses({"--blended", stockpiles.folder() / "limits.csv"}, "would be overwritten");
  check_refused(mdm({"blend", stockpiles.folder() / "fine.csv"}), "--spec");
}

TEST_CASE("a limit below the finest sieve of a stockpile, and factors in a blend, are refused", "[cli]") {
  const Stockpiles stockpiles;
  const TemporaryFolder &folder = stockpiles.folder();
  const std::string open = folder.write("open.csv", "size_mm,passing_percent\n8,100\n4,40\n2,10\n");
  check_refused(mdm({"blend", open, "--spec", folder / "limits.csv"}),
                "open: what passes 1 mm is not known, since it lies below its finest sieve");
  const std::string dense =
      folder.write("dense.csv", "size_mm,mass,factor\n8,0,1\n4,35,2.65\n1,45,2.65\n0.5,20,2.65\n");
  CHECK(mdm({"blend", dense, "--spec", folder / "limits.csv"}).exit_code == 0);
  check_refused(mdm({"blend", dense, "--spec", folder / "limits.csv", "--blended", folder / "mix.csv"}),
                "dense: it has a column factor");
}

TEST_CASE("the proof of a blend is accepted, and so is that of none", "[cli]") {
  const auto proved = [](const Stockpiles &stockpiles, Arguments options, int exit_code) {
    const std::string proof = stockpiles.folder() / "mix.proof";
    options.insert(options.end(), {"--proof", proof});
    CHECK(stockpiles.blend(options).exit_code == exit_code);
    const TemporaryFolder &folder = stockpiles.folder();
    const Outcome verdict =
        Process(MDM_CHECK_PROGRAM, {folder / "limits.csv", folder / "fine.csv", folder / "coarse.csv", proof})
            .end();
    INFO(verdict.out << verdict.err);
    CHECK(verdict.exit_code == 0);
    return verdict.out;
  };
  const std::string limits = "8,100,100\n4,60,70\n1,10,30\n";
  CHECK(contains(proved(Stockpiles(limits), {"--cost", "fine=10,coarse=4"}, 0),
                 "none has a lower cost than its 151/25"));
  CHECK(contains(proved(Stockpiles("8,100,100\n4,60,70\n1,0,10\n"), {}, 1), "accepted: no blend"));
  CHECK(contains(proved(Stockpiles("8,100,100\n4,60,60.1\n"), {}, 1), "accepted: no blend"));
  proved(Stockpiles(limits), {"--at-most-stockpiles", "1", "--share", "fine=..90%"}, 1);
}

TEST_CASE("the proof of a blend is written for VIPR checkers where its question is linear", "[cli]") {
  const Stockpiles stockpiles("8,100,100\n4,60,70\n1,10,30\n");
  const std::string file = stockpiles.folder() / "mix.vipr";
  CHECK(stockpiles.blend({"--cost", "fine=10,coarse=4", "--vipr", file}).exit_code == 0);
  CHECK(contains(read_file(file), "RTP range 151/25 151/25\nSOL 1\n"));
  const Stockpiles none("8,100,100\n4,60,60.1\n");
  CHECK(none.blend({"--vipr", file}).exit_code == 1);
  CHECK(contains(read_file(file), "RTP infeas\nSOL 0\n"));
  check_refused(stockpiles.blend({"--at-most-stockpiles", "1", "--vipr", stockpiles.folder() / "b.vipr"}),
                "--vipr: its conditions are linear");
  CHECK_FALSE(std::filesystem::exists(stockpiles.folder() / "b.vipr"));
  check_refused(stockpiles.blend({"--vipr", "-"}), "--vipr needs a file");
}

TEST_CASE("a proof of files that mdm-check does not read is refused", "[cli]") {
  const Stockpiles open; // its largest sieve lets 70 percent pass at most
  const std::string proof = open.folder() / "mix.proof";
  check_refused(open.blend({"--proof", proof}), "largest sieve that lets 100 percent pass");
  CHECK_FALSE(std::filesystem::exists(proof));
  const Stockpiles stockpiles("8,100,100\n4,60,70\n");
  stockpiles.folder().write("fine.csv", "Sieve size (mm),Cumulative % passing\n8,100\n4,100\n1,60\n0.5,0\n");
  CHECK(stockpiles.blend().exit_code == 0);
  check_refused(stockpiles.blend({"--proof", proof}), "--proof: mdm-check does not read");
}

TEST_CASE("Ctrl-C ends a search for blends with what is certain", "[cli]") {
  const Stockpiles stockpiles("8,100,100\n4,60,70\n1,10,30\n");
  const TemporaryFolder &folder = stockpiles.folder();
  Process search(MDM_PROGRAM, {"blend", folder / "fine.csv", folder / "coarse.csv", "--spec",
                               folder / "limits.csv", "--cost", "fine=10,coarse=4", "--step", "0.0000001%",
                               "--all", "1000000", "--proof", folder / "proof"});
  std::this_thread::sleep_for(std::chrono::seconds(1)); // it is searching by now
  search.signal(SIGINT);
  const Outcome outcome = search.end();
  CHECK(outcome.exit_code == 3);
  CHECK(contains(outcome.out, "of the 1000000 blends that were asked for"));
  CHECK(contains(outcome.out, "the search was interrupted"));
  CHECK(mdm_check({folder / "limits.csv", folder / "fine.csv", folder / "coarse.csv", folder / "proof"})
            .exit_code == 0);
}

TEST_CASE("what cannot be written is said before there is a report", "[cli]") {
  const Stockpiles stockpiles("8,100,100\n4,60,70\n1,10,30\n");
  const std::string blended = stockpiles.folder() / "mix.csv";
  for (const char *option : {"--proof", "--vipr"}) {
    const Outcome outcome = stockpiles.blend({"--blended", blended, option, "/nowhere/x"});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(std::filesystem::exists(blended));
  }
  const Stockpiles none("8,100,100\n4,60,60.1\n");
  const std::string stale = none.folder().write("mix.csv", "old");
  const Outcome outcome = none.blend({"--blended", stale});
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.err, "mix.csv is not written"));
  CHECK(read_file(stale) == "old");
}

TEST_CASE("a blend says what of the question it leaves aside, and what a share cannot be", "[cli]") {
  const TemporaryFolder folder;
  const std::string u = folder.write("u.csv", "size_mm,passing_percent\n10,100\n2,80\n1,60\n0.1,0\n"),
                    v = folder.write("v.csv", "size_mm,passing_percent\n10,100\n2,40\n1,10\n0.1,0\n"),
                    few = folder.write("few.csv",
                                       "size_mm,passing_min_percent,passing_max_percent\n10,100,100\n"),
                    crossed = folder.write(
                        "s.csv", "size_mm,passing_min_percent,passing_max_percent\n10,100,100\n1,60,40\n");
  const Outcome aimed = mdm({"blend", u, v, "--spec", few, "--target", u});
  CHECK(aimed.exit_code == 0);
  CHECK(contains(aimed.out,
                 "the target u is counted at the sieves of the specification alone: not at 0.1, 1, 2 mm"));
  check_refused(mdm({"blend", u, v, "--spec", crossed}), "at least 60 % and at most 40 % passing 1 mm");
  const Outcome between = mdm({"blend", u, v, "--spec", few, "--share", "u=50.2..50.8%"});
  CHECK(between.exit_code == 1);
  CHECK(contains(between.out, "no share of u in steps of 1 % is from 50.2 to 50.8 %: take finer steps"));
  check_refused(mdm({"blend", u, v, "--spec", few, "--share", "u=10%,u=20%"}),
                "no share of u is from 20 to 10 %");
  const Outcome fine = mdm({"blend", u, v, "--spec", few, "--step", "0.000001%", "--share", "u=66.666666%"});
  CHECK(contains(fine.out, "66.666666 % u, 33.333334 % v"));
}

TEST_CASE("a real optimum that is rounded to steps breaks the number of stockpiles, too", "[cli]") {
  const TemporaryFolder folder;
  const auto pile = [&folder](const char *name, const char *at_one) {
    return folder.write(name, std::string("size_mm,passing_percent\n10,100\n1,") + at_one + "\n0.1,0\n");
  };
  const Outcome outcome =
      mdm({"blend", pile("a.csv", "80"), pile("b.csv", "20"), pile("c.csv", "45"), "--spec",
           folder.write("s.csv", "size_mm,passing_min_percent,passing_max_percent\n10,100,100\n1,38,62\n"),
           "--cost", "a=1,b=2,c=9", "--at-most-stockpiles", "1"});
  CHECK(contains(outcome.out, "breaks 1 limit: at most 1 stockpile\n"));
}

TEST_CASE("stockpiles, blend and limits are drawn", "[cli]") {
  const Stockpiles piles;
  CHECK(piles.blend({"--plot", piles.folder() / "p.svg"}).exit_code == 0);
  const std::string picture = read_file(piles.folder() / "p.svg");
  for (const char *title : {">blend<", ">fine<", ">coarse<", "allowed: limits"})
    CHECK(picture.find(title) != std::string::npos);
  const Stockpiles none("4,60,70\n1,50,60\n");
  CHECK(none.blend({"--plot", none.folder() / "p.svg"}).exit_code == 1);
  CHECK(read_file(none.folder() / "p.svg").find(">blend<") == std::string::npos);
  CHECK(read_file(none.folder() / "p.svg").find(">no blend<") != std::string::npos);
  check_refused(piles.blend({"--plot", piles.folder() / "p.doc"}), "--plot");
}

TEST_CASE("limits that come with mdm are given by their name", "[cli]") {
  const TemporaryFolder folder;
  const std::string a = folder.write(
      "a.csv",
      "size_mm,passing_percent\n9.5,100\n4.75,97\n2.36,88\n1.18,70\n0.6,45\n0.3,18\n0.15,4\n0.075,0\n");
  CHECK(mdm({"blend", a, a, "--spec", "astm-c33-fine"}).exit_code == 2); // two stockpiles of one name
  const std::string b = folder.write("b.csv", read_file(a));
  CHECK(mdm({"blend", a, b, "--spec", "astm-c33-fine"}).exit_code == 0);
  check_refused(mdm({"blend", a, b, "--spec", "astm-c33-fine", "--proof", folder / "p"}),
                "mdm-check reads files");
}

TEST_CASE("a fineness modulus is limited, told and proved", "[cli]") {
  const TemporaryFolder folder;
  const std::string fine = folder.write("fine.csv", "size_mm,passing_percent\n4,100\n1,100\n0.1,0\n"),
                    coarse = folder.write("coarse.csv", "size_mm,passing_percent\n4,100\n1,0\n0.1,0\n"),
                    spec = folder.write(
                        "limits.csv",
                        "size_mm,passing_min_percent,passing_max_percent\n4,100,100\n1,10,100\n"),
                    proof = folder / "proof";
  const Arguments blend = {"blend", fine, coarse, "--spec", spec, "--quiet", "--limit"};
  const auto with = [&blend](const Arguments &more) {
    Arguments all = blend;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  // Of 0.125, 0.25 and 0.5 mm 1/36, 1/6 and 4/9 of the fine sand pass, of 1, 2 and 4 mm all: 2.3611; the
  // coarse one passes 1/3 of 2 mm and all of 4 mm: 4.6667.
  const Outcome found = mdm(with({"FM-EN=..3", "--cost", "fine=2,coarse=1", "--proof", proof}));
  CHECK(found.exit_code == 0);
  CHECK(contains(found.out, "73 % fine, 27 % coarse: within limits"));
  CHECK(contains(found.out, "fineness modulus FM-EN         -  2.98361        3"));
  const Outcome verdict = mdm_check({spec, fine, coarse, proof});
  CHECK(verdict.exit_code == 0);
  CHECK(contains(verdict.out, "fineness modulus of EN 12620 from 0 to 3"));
  const Outcome none = mdm(with({"FM-EN=..2"}));
  CHECK(none.exit_code == 1);
  CHECK(contains(none.out, "FM-EN at most 2, which is at least 200/3 % passing on the mean of its sieves"));
  for (const Arguments &wrong :
       {Arguments{"FM=2"}, {"retained=..45%"}, {"FM=12.."}, {"FM=1..2", "--limit", "FM=1..3"}}) {
    const Outcome refused = mdm(with(wrong));
    CHECK(refused.exit_code == 2);
    CHECK(refused.out.empty());
  }
}

TEST_CASE("least squares from a target, told and proved", "[cli]") {
  const Stockpiles stockpiles("8,100,100\n4,60,70\n1,10,30\n");
  const std::string curve = stockpiles.folder().write("curve.csv",
                                                      "size_mm,passing_percent\n8,100\n4,65\n1,18\n0.5,0\n"),
                    proof = stockpiles.folder() / "proof";
  const Arguments squares = {"--target", curve, "--minimise", "squares", "--proof", proof};
  // (60 f - 25)^2 + (60 f - 18)^2 is least at 60 f = 21.5: 24.5; in steps at 36 %, (-3.4)^2 + 3.6^2.
  const Json answer = stockpiles.json(squares);
  CHECK(answer.at("aim") == "squares");
  CHECK(answer.at("real").at("value") == "49/2");
  CHECK(shares(answer.at("real")).at(0) == Rational(215, 600));
  CHECK(answer.at("blends").at(0).at("value") == "613/25");
  CHECK(shares(answer.at("blends").at(0)).at(0) == Rational(36, 100));
  const Outcome verdict = mdm_check({stockpiles.folder() / "limits.csv", stockpiles.folder() / "fine.csv",
                                     stockpiles.folder() / "coarse.csv", proof});
  CHECK(verdict.exit_code == 0);
  CHECK(contains(verdict.out, "none has a lower sum of squared deviations from the target than its 613/25"));
  check_refused(stockpiles.blend({"--minimise", "squares"}), "it needs --target");
}

TEST_CASE("the coarseness factor is limited, told and proved", "[cli]") {
  const TemporaryFolder folder;
  // On 2.36 mm stay 50 and 100 percent, on 9.5 mm 10 and 80: with the share f of the first the factor is
  // 100 (80 - 70 f) / (100 - 50 f), at most 60 from f = 1/2 on, at least 50 up to f = 2/3.
  const std::string a = folder.write("a.csv", "size_mm,passing_percent\n19,100\n9.5,90\n2.36,50\n0.1,0\n"),
                    b = folder.write("b.csv", "size_mm,passing_percent\n19,100\n9.5,20\n2.36,0\n"),
                    spec = folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n"
                                                      "19,100,100\n2.36,0,45\n"),
                    proof = folder / "proof";
  const auto blend = [&](const Arguments &more) {
    Arguments all = {"blend", a, b, "--spec", spec};
    all.insert(all.end(), more.begin(), more.end());
    return mdm(all);
  };
  CHECK(
      contains(mdm({"blend", folder.write("fine.csv", "size_mm,passing_percent\n2.36,100\n0.1,0\n"), "--spec",
                    folder.write("wide.csv", "size_mm,passing_min_percent,passing_max_percent\n19,100,100\n"),
                    "--limit", "CF=50..60"})
                   .out,
               "nothing stays on 2.36 mm: such a blend has no factor CF"));
  for (const auto &[costs, share, value] :
       {std::tuple{"a=2,b=1", "50 % a, 50 % b", "60"}, std::tuple{"a=1,b=2", "66 % a, 34 % b", "50.4477"}}) {
    const Outcome found = blend({"--limit", "CF=50..60%", "--cost", costs, "--proof", proof});
    CHECK(contains(found.out, share));
    CHECK(contains(found.out, "coarseness factor CF"));
    CHECK(contains(found.out, value));
    const Outcome verdict = mdm_check({spec, a, b, proof});
    CHECK(verdict.exit_code == 0);
    CHECK(contains(verdict.out, "; coarseness factor from 50 to 60;"));
  }
  const Outcome none = blend({"--limit", "CF=..15", "--proof", proof});
  CHECK(none.exit_code == 1);
  CHECK(contains(none.out,
                 "coarseness factor at most 15, which is at least 85 % passing 9.5 mm less 0.15 times"));
  CHECK(mdm_check({spec, a, b, proof}).exit_code == 0);
  check_refused(blend({"--limit", "CF=101.."}), "CF is from 0 to 100");
  check_refused(blend({"--limit", "CF=1..2", "--limit", "CF=3..4"}), "CF is limited twice");
  check_refused(blend({"--limit", "WF=1..2"}),
                "'WF=1..2' is no limit: write FM=2.3..3.1, FM-EN=2.4..3.0 or CF=45..75");
}

TEST_CASE("an answer with a coarseness factor is a problem for many, and what is wrong in one is told",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string stockpiles = R"("stockpiles":[{"name":"a","passing":["100"],"coarse":["90","50"]},)"
                                 R"({"name":"b","passing":["100"],"coarse":["20","0"]}],)"
                                 R"("sieves":[{"size":"19","least":"100"}],"steps":"100",)";
  const std::string lines = folder.write(
      "problems.jsonl", "{" + stockpiles + R"("coarseness":{"least":"50","most":"60"}})" + "\n{" +
                            stockpiles + R"("coarseness":{"least":"60","most":"50"}})" + "\n" +
                            R"({"stockpiles":[{"name":"a","passing":["100"]}],"sieves":[{"size":"19"}],)" +
                            R"("coarseness":{"least":"50"}})" + "\n");
  const Outcome outcome = mdm({"blend", "--problems", lines});
  CHECK(contains(outcome.out, R"("shares":["1/2","1/2"])"));
  CHECK(contains(outcome.out, R"("coarseness":"60")"));
  CHECK(contains(outcome.out, "coarseness: its limits are not in order from 0 to 100"));
  CHECK(contains(outcome.out, "stockpiles[0].coarse is missing"));
  const std::string answer = folder.write("answer.jsonl", outcome.out.substr(0, outcome.out.find('\n') + 1));
  CHECK(mdm({"blend", "--problems", answer}).out == outcome.out.substr(0, outcome.out.find('\n') + 1));
}

TEST_CASE("the ratios of the Bailey method are reported where they are asked for", "[cli]") {
  const TemporaryFolder folder;
  const std::string a = folder.write(
                        "a.csv",
                        "size_mm,passing_percent\n9.5,100\n4.75,80\n2.36,40\n0.6,20\n0.15,8\n0.1,0\n"),
                    b = folder.write("b.csv", "size_mm,passing_percent\n9.5,100\n4.75,40\n2.36,20\n0.6,0\n"),
                    spec = folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n"
                                                      "9.5,100,100\n4.75,60,60\n");
  const Arguments question = {"blend", a, b, "--spec", spec};
  const auto with = [&question](const Arguments &more) {
    Arguments all = question;
    all.insert(all.end(), more.begin(), more.end());
    return mdm(all);
  };
  // Half and half: 60, 30, 10 and 4 percent pass.
  const Json bailey = Json::parse(with({"--bailey", "9.5mm", "--format", "json"}).out).at("bailey");
  CHECK(bailey.at("sieves") == Json({"19/4", "59/25", "3/5", "3/20"}));
  CHECK(bailey.at("passing") == Json({"60", "30", "10", "4"}));
  CHECK(bailey.at("CA") == "3/4");
  CHECK(bailey.at("FAc") == "1/3");
  CHECK(bailey.at("FAf") == "2/5");
  CHECK(bailey.at("interpolated") == false);
  CHECK(contains(with({"--bailey", "9.5mm"}).out,
                 "  fine of the fine, FAf      0.6, 0.15    10, 4       0.4\n"));
  CHECK(contains(with({"--bailey", "12.5mm"}).out, "is interpolated, linear in size"));
  CHECK_FALSE(Json::parse(with({"--format", "json"}).out).contains("bailey"));
  check_refused(with({"--bailey", "10mm"}), "there are 37.5, 25, 19, 12.5, 9.5, 4.75 mm");
}

} // namespace blend_test
