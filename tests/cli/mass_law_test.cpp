// Mass laws by table and by sum, as a user has them: files, units, messages, proofs.

#include "answer.hpp"

namespace mass_law_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");
const std::string table = "size_mm,particle_mass\n0,0\n0.1,0.001\n1,1\n20,9000\n";

/// The answer under a law, whose proof is accepted and which is judged a match.
Json proved_under(const std::string &law, const std::string &gradation, const Arguments &options = {}) {
  const TemporaryFolder folder;
  Arguments arguments{gradation, "--law", law, "--proof", folder / "proof"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  Json answer = solve_json(arguments);
  const Outcome verdict = mdm_check(gradation, folder / "proof");
  INFO(verdict.out << verdict.err);
  CHECK(verdict.exit_code == 0);
  Arguments judged{"verify", gradation, folder.write("a.json", answer.dump()), "--law", law};
  judged.insert(judged.end(), options.begin(), options.end());
  CHECK(mdm(judged).exit_code == 0);
  return answer;
}

} // namespace

TEST_CASE("a law by table or sum is one of sizes in mm, in whatever unit the gradation is", "[cli]") {
  const TemporaryFolder folder;
  const std::string law = "table:" + folder.write("law.csv", table);
  const std::string mm = folder.write("mm.csv", "size_mm,mass\n0.063,1\n0.125,3\n0.25,2\n0.5,0\n"),
                    um = folder.write("um.csv", "size_um,mass\n63,1\n125,3\n250,2\n500,0\n");
  for (const std::string &of : {law, std::string("sum:2*x^3+1/3*x")})
    for (const Arguments &options : {Arguments{}, Arguments{"--tolerance", "2%"}}) {
      const Json a = proved_under(of, mm, options), b = proved_under(of, um, options);
      CHECK(a.at("particles") == b.at("particles"));
      CHECK(a.at("scale").at("chosen") == b.at("scale").at("chosen"));
    }
  CHECK(proved_under(law, mm).at("particles") == "6");
}

TEST_CASE("a sum of x^3 alone is the sphere, but for its name", "[cli]") {
  Json sphere = solve_json({athabasca, "--law", "sphere"});
  Json sum = solve_json({athabasca, "--law", "sum:1*x^3"});
  for (const char *key : {"question", "solids_volume"}) {
    sphere.erase(key);
    sum.erase(key);
  }
  CHECK(sphere == sum);
}

TEST_CASE("bad laws are refused with file and line, and where they do not serve", "[cli]") {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.csv", "size_mm,particle_mass\n1,2\n2,2\n"),
                    good = folder.write("good.csv", table),
                    small = folder.write("small.csv", "size_mm,particle_mass\n1,1\n");
  const auto refused = [&](const std::string &law, const std::string &message, const Arguments &more = {}) {
    Arguments arguments{"solve", athabasca, "--law", law, "-o", folder / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    check_refused(mdm(arguments), message);
  };
  refused("table:" + bad, "bad.csv:3: particle_mass 2 is not above the 2 before it");
  refused("table:" + small, "is beyond the table of the mass law, which ends at 1");
  refused("table:" + (folder / "none.csv"), "none.csv: cannot be read");
  refused("sum:2x", "is no term c*x^n");
  refused("sum:x^2", "needs spheres", {"--solids-volume", "5"});
  refused("table:" + good, "--coq: the theorem is of laws that are powers", {"--coq", folder / "proof.v"});
  refused("table:" + good, "a law that is a power alone", {"--spread"});
}

TEST_CASE("no output takes the place of the table of a law", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("law.csv", table), law = "table:" + file,
                    g = folder.write("g.csv", "size_mm,mass\n0.063,1\n0.125,3\n0.25,2\n0.5,0\n"),
                    sample = folder.write("s.csv", "size_mm,quantity\n0.1,1\n0.2,1\n0.4,1\n"),
                    suite = folder.write("suite.jsonl", R"({"sizes":["1","2"],"masses":["1","0"]})"
                                                        "\n"),
                    answers = folder.write("answers.csv", "id,quantities\n1,1\n"), link = folder / "link.csv";
  std::filesystem::create_symlink(file, link);
  const Arguments commands[] = {{"solve", g, "--law", law, "-o", file},
                                {"solve", g, "--law", law, "-o", link},
                                {"solve", g, "--law", law, "--proof", file},
                                {"solve", g, "--law", law, "--vipr", file},
                                {"batch", suite, "--law", law, "-o", file},
                                {"batch", suite, "--law", law, "--proofs", file},
                                {"tradeoff", g, "--law", law, "-o", file},
                                {"verify", g, sample, "--law", law, "-o", file},
                                {"verify", g, sample, "--law", law, "--proof", file},
                                {"crosscheck", suite, answers, "--law", law, "-o", file},
                                {"crosscheck", suite, "--solver", "true", "--law", law, "--journal", file},
                                {"published", "rounded", g, "--law", law, "-o", file},
                                {"convert", g, "--problem", "lp", "--law", law, "-o", file},
                                {"export", g, "--to", "csv", "--law", law, "-o", file}};
  for (const Arguments &command : commands) {
    const Outcome outcome = mdm(command);
    INFO(command[0] << ' ' << command[command.size() - 2] << ": " << outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(read_file(file) == table);
  }
  const std::string limits = "size_mm,passing_min_percent,passing_max_percent\n2,100,100\n",
                    band = folder.write("band.csv", limits);
  check_refused(mdm({"crosscheck", suite, answers, "--band", band, "-o", band}), "would be overwritten");
  CHECK(read_file(band) == limits);
}

} // namespace mass_law_test
