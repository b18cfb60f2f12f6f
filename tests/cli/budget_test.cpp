// Budgets of particles, as users ask for them.

#include "answer.hpp"

namespace budget_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");
/// Two gradations; 3 particles suffice for an exact match of the second alone.
const std::string lines = R"({"id":"a","sizes":["1","2","4"],"masses":["70","30","0"]}
{"id":"b","sizes":["1","2"],"masses":["1","0"]}
)";

} // namespace

TEST_CASE("a budget chooses the least tolerance, and two proofs say so", "[cli]") {
  const TemporaryFolder folder;
  const Json answer =
      solve_json({athabasca, "--particles", "500", "--tolerance", "passing", "--proof", folder / "proof"});
  const Json &budget = answer.at("budget");
  CHECK(budget.at("particles") == "500");
  CHECK(budget.at("tolerance") == "3.423");
  CHECK(budget.at("next_finer") == "3.422");
  CHECK(Integer(answer.at("particles").get<std::string>()) <= 500);
  const Outcome fits = mdm_check(athabasca, folder / "proof");
  CHECK(fits.exit_code == 0);
  CHECK(fits.out.find("N = 500 is the smallest") != std::string::npos);
  CHECK(fits.out.find("passing within 3.423%") != std::string::npos);
  const Outcome more = mdm_check(athabasca, folder / "proof.finer");
  CHECK(more.exit_code == 0);
  CHECK(more.out.find("501") != std::string::npos);
  CHECK(more.out.find("passing within 3.422%") != std::string::npos);
}

TEST_CASE("a budget is of the shares retained unless told otherwise, on a grid", "[cli]") {
  const Json fine = solve_json({athabasca, "--particles", "500"});
  CHECK(fine.at("budget").at("tolerance") == "2.823");
  const Json coarse = solve_json({athabasca, "--particles", "500", "--grid", "0.5"});
  CHECK(coarse.at("budget").at("tolerance") == "3");
  CHECK(coarse.at("budget").at("next_finer") == "2.5");
  const Json exact = solve_json({athabasca, "--particles", "1485"});
  CHECK(exact.at("budget").at("tolerance") == "0");
  CHECK(exact.at("budget").at("next_finer").is_null());
  const Outcome text = mdm({"solve", athabasca, "--particles", "500"});
  CHECK(text.out.find("500 particles: the tolerance 2.823% suffices, 2.822% does not") != std::string::npos);
  const Outcome enough = mdm({"solve", athabasca, "--particles", "1485"});
  CHECK(contains(enough.out, "1485 particles: the tolerance 0% suffices\n"));
  const Outcome none = mdm({"solve", athabasca, "--particles", "1", "--min-per-class", "2"});
  CHECK(contains(none.out, "1 particle: no tolerance suffices\n"));
}

TEST_CASE("a budget that suffices for no tolerance is a negative verdict with a proof", "[cli]") {
  const TemporaryFolder folder;
  const Json none =
      solve_json({athabasca, "--particles", "1", "--min-per-class", "2", "--proof", folder / "proof"}, 1);
  CHECK(none.at("budget").at("tolerance").is_null());
  CHECK(none.at("budget").at("next_finer") == "100");
  CHECK(mdm_check(athabasca, folder / "proof").exit_code == 0);
}

TEST_CASE("a budget chooses the least size factor for a specimen, and two proofs say so", "[cli]") {
  const TemporaryFolder folder;
  const Arguments specimen = {athabasca, "--specimen", "cylinder:50x100", "--void-ratio", "0.6"};
  const auto with = [&specimen](Arguments more) {
    more.insert(more.begin(), specimen.begin(), specimen.end());
    return more;
  };
  const Json answer =
      solve_json(with({"--particles", "20000", "--by", "size-factor", "--proof", folder / "proof"}));
  const Json &budget = answer.at("budget");
  CHECK(budget.at("size_factor") == "12.31");
  CHECK(budget.at("next_finer") == "12.309");
  CHECK_FALSE(budget.contains("tolerance"));
  const Outcome fits = mdm_check(athabasca, folder / "proof");
  CHECK(fits.exit_code == 0);
  CHECK(fits.out.find("N = 19999 is the smallest") != std::string::npos);
  CHECK(fits.out.find("multiplied by 12.31;") != std::string::npos);
  const Outcome more = mdm_check(athabasca, folder / "proof.finer");
  CHECK(more.exit_code == 0);
  CHECK(more.out.find("N = 20004 is the smallest") != std::string::npos);
  CHECK(more.out.find("multiplied by 12.309;") != std::string::npos);
  CHECK(solve_json(with({"--particles", "20000", "--by", "size-factor", "--grid", "0.5"}))
            .at("budget")
            .at("size_factor") == "12.5");
  CHECK(solve_json(with({"--particles", "40000000", "--by", "size-factor"})).at("budget").at("size_factor") ==
        "1");
  const Outcome text = mdm({"solve", athabasca, "--specimen", "cylinder:50x100", "--void-ratio", "0.6",
                            "--particles", "1484", "--by", "size-factor"});
  CHECK(text.out.find("1484 particles: no size factor suffices: without the specimen no match has so few") !=
        std::string::npos);
  const Json none = solve_json(with({"--particles", "1484", "--by", "size-factor"}), 1);
  CHECK(none.at("budget").at("size_factor").is_null());
  CHECK(solve_json(with({"--particles", "1485", "--by", "size-factor"})).at("particles") == "1485");
}

TEST_CASE("each gradation of a batch has the answer to the budget that it has alone", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", lines);
  for (const Arguments &budget : {Arguments{"--particles", "3"},
                                  Arguments{"--particles", "3", "--tolerance", "passing", "--grid", "0.5"}}) {
    Arguments arguments = {"batch", suite};
    arguments.insert(arguments.end(), budget.begin(), budget.end());
    const std::vector<std::string> answers = lines_of(mdm(arguments).out);
    REQUIRE(answers.size() == 2);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      Arguments alone = {folder.write("one.json", lines_of(lines)[i])};
      alone.insert(alone.end(), budget.begin(), budget.end());
      CHECK(Json::parse(answers[i]) == solve_json(alone));
    }
  }
}

TEST_CASE("a folder of proofs has both of a budget, a stream says that it has one", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", lines), proofs = folder / "proofs";
  REQUIRE(mdm({"batch", suite, "--particles", "3", "--proofs", proofs, "-o", folder / "a.jsonl"}).exit_code ==
          0);
  const std::string first = folder.write("first.json", lines_of(lines)[0]);
  const Outcome fits = mdm_check(first, proofs + "/000001-a.proof");
  CHECK(contains(fits.out, "accepted: N = 3 is"));
  const Outcome more = mdm_check(first, proofs + "/000001-a.proof.finer");
  CHECK(contains(more.out, "accepted: N = 4 is"));
  CHECK_FALSE(std::filesystem::exists(proofs + "/000002-b.proof.finer")); // it matches exactly
  const Outcome all = mdm_check({"--suite", suite, proofs});
  CHECK(contains(all.out, "3 accepted, 0 refused"));

  const std::string stream = folder / "all.proofs";
  const Outcome streamed = mdm({"batch", suite, "--particles", "3", "--proofs", stream});
  CHECK(contains(lines_of(streamed.out)[0], "that of the next finer step"));
  CHECK_FALSE(contains(lines_of(streamed.out)[1], "that of the next finer step"));
  CHECK(mdm_check({"--suite", suite, stream}).exit_code == 0);
}

TEST_CASE("a second proof that is none, or of no line, is malformed", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", lines), proofs = folder / "proofs";
  REQUIRE(mdm({"batch", suite, "--particles", "3", "--proofs", proofs, "-o", folder / "a.jsonl"}).exit_code ==
          0);
  const std::string finer = proofs + "/000001-a.proof.finer";
  std::filesystem::rename(finer, proofs + "/7.proof.finer");
  CHECK(contains(mdm_check({"--suite", suite, proofs}).out, "begins with the number of no line"));
  std::filesystem::remove(proofs + "/7.proof.finer");
  std::ofstream(finer) << "no certificate\n";
  const Outcome broken = mdm_check({"--suite", suite, proofs});
  CHECK(broken.exit_code == 2);
  CHECK(contains(broken.out, "2 accepted, 0 refused, 1 malformed"));
}

TEST_CASE("a proof of a budget that lies there from another run is told", "[cli]") {
  const TemporaryFolder folder;
  const std::string proof = folder / "proof";
  REQUIRE(mdm({"solve", athabasca, "--particles", "500", "--proof", proof}).exit_code == 0);
  CHECK(contains(mdm({"solve", athabasca, "--proof", proof}).out, ".finer is of another run"));
}

TEST_CASE("that no size factor suffices has a proof", "[cli]") {
  const TemporaryFolder folder;
  const Outcome none = mdm({"solve", athabasca, "--particles", "1484", "--by", "size-factor", "--specimen",
                            "cylinder:50x100", "--void-ratio", "0.6", "--proof", folder / "proof"});
  CHECK(none.exit_code == 1);
  const Outcome verdict = mdm_check(athabasca, folder / "proof");
  CHECK(verdict.exit_code == 0);
  CHECK(contains(verdict.out, "1485"));
  CHECK_FALSE(contains(verdict.out, "cylinder"));
}

TEST_CASE("shards of different budgets are not one run", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", lines);
  for (const char *const shard : {"1", "2"})
    REQUIRE(mdm({"batch", suite, "--shard", std::string(shard) + "/2", "--particles", shard, "-o",
                 folder / (std::string(shard) + ".jsonl")})
                .exit_code == 0);
  check_refused(mdm({"merge", folder / "1.jsonl", folder / "2.jsonl", "-o", folder / "all.jsonl"}),
                "--particles 2");
}

TEST_CASE("where a table has no place for a budget it is on standard error", "[cli]") {
  const std::string told = "athabasca-sand: 500 particles: the tolerance 2.823% suffices, 2.822% does not\n";
  for (const char *const command : {"solve", "batch"}) {
    CAPTURE(command);
    CHECK(mdm({command, athabasca, "--particles", "500", "--format", "csv"}).err == told);
    CHECK(mdm({command, athabasca, "--particles", "500", "--format", "csv", "--quiet"}).err.empty());
  }
  const TemporaryFolder folder;
  const Outcome exported =
      mdm({"export", athabasca, "--to", "diameters", "--particles", "500", "-o", folder / "d.txt"});
  CHECK(contains(exported.err, told));
}

TEST_CASE("particles of a budget are exported, and their check names what it chose", "[cli]") {
  const TemporaryFolder folder;
  const std::string data = folder / "sand.data";
  const Arguments asked = {"export", athabasca, "--to", "lammps", "--particles", "20000", "-o", data};
  const auto checked = [&](Arguments more, const std::string &chosen) {
    more.insert(more.begin(), asked.begin(), asked.end());
    const std::string err = mdm(more).err;
    const std::string before = "check it by: mdm ";
    std::istringstream words(err.substr(err.find(before) + before.size()));
    Arguments check;
    for (std::string word; words >> word;)
      check.push_back(word);
    REQUIRE(contains(err, chosen));
    CHECK(mdm(check).exit_code == 0);
  };
  checked({"--specimen", "cylinder:5x10", "--void-ratio", "0.7", "--by", "size-factor"},
          "--size-factor 1.207 ");
  checked({"--min-per-class", "40"}, "--tolerance 2.8189884 --tolerance passing:");
  checked({"--min-per-class", "40", "--tolerance", "total"}, " --tolerance total:");
}

TEST_CASE("options that do not go with a budget are refused", "[cli]") {
  const auto refused = [](Arguments options, const std::string &part) {
    options.insert(options.begin(), {"solve", athabasca});
    check_refused(mdm(options), part);
  };
  refused({"--particles", "0"}, "--particles");
  refused({"--particles", "5", "--tolerance", "passing:1%"}, "write retained, passing or total");
  refused({"--particles", "5", "--tolerance", "laboratory"}, "write retained, passing or total");
  refused({"--particles", "5", "--tolerance", "passing", "--tolerance", "total"}, "--particles");
  refused({"--particles", "5", "--at-most", "4"}, "--at-most");
  refused({"--particles", "5", "--grid", "0"}, "--grid");
  refused({"--particles", "5", "--spectrum"}, "--spectrum");
  refused({"--grid", "1"}, "--grid");
  refused({"--by", "size-factor"}, "--by");
  refused({"--particles", "5", "--by", "sizes"}, "write tolerance or size-factor");
  refused({"--particles", "5", "--by", "size-factor"}, "add --specimen");
  refused({"--particles", "5", "--by", "size-factor", "--solids-volume", "9", "--size-factor", "2"},
          "--size-factor");
  refused({"--particles", "5000", "--by", "size-factor", "--solids-volume", "9", "--law", "power:2"},
          "sphere");
  refused({"--particles", "5", "--by", "size-factor", "--solids-volume", "9", "--at-most", "2"}, "--at-most");
  refused({"--particles", "5", "--by", "size-factor", "--solids-volume", "9", "--tolerance", "retained"},
          "--tolerance");
}

} // namespace budget_test
