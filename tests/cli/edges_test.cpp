// Defects at the edges of the program, each with its number.

#include "answer.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>

using namespace cli_test;

namespace {

bool contains(const std::string &text, const std::string &part) {
  UNSCOPED_INFO(text.substr(0, 2000) << "\nexpected: " << part);
  return text.find(part) != std::string::npos;
}

/// Sieves so close that a sweep would take 10^12 steps.
std::string endless(const std::string &id = "endless") {
  return R"({"id":")" + id +
         R"(","sizes":["7","7.000000000002","7.000000000004","7.000000000006"],"masses":[1,3,2,0]})";
}

const std::string small = R"({"id":"small","sizes":[1,2,3],"masses":[2,1,0]})";

constexpr long megabyte = 1024; // KiB

} // namespace

TEST_CASE("edge 4: within a tolerance the exact match takes a small share of the limits", "[cli]") {
  const Outcome outcome = mdm({"solve", "-", "--tolerance", "retained:1%", "--format", "json"}, endless());
  CHECK(outcome.exit_code == 0);
  CHECK(Json::parse(outcome.out).at("status") == "optimal");
  CHECK(outcome.max_rss_kib < 100 * megabyte);
}

TEST_CASE("edge 5: a lower bound above --at-most is an answer, also where no match was found", "[cli]") {
  const TemporaryFolder folder;
  const std::string band =
      folder.write("b.csv", "size_mm,passing_min_percent,passing_max_percent\n2,20,30\n4,40,60\n");
  const std::string gradation = folder.write("g.csv", "size_mm,passing_percent\n1,0\n2,60\n4,90\n8,100\n");
  const Arguments question = {"solve", gradation, "--band", band, "--law", "power:2", "--at-most", "3"};
  Arguments as_json = question;
  as_json.insert(as_json.end(), {"--format", "json"});
  const Outcome none = mdm(as_json);
  INFO(none.out << none.err);
  CHECK(none.exit_code == 1);
  const Json answer = Json::parse(none.out);
  CHECK(answer.at("status") == "none");
  CHECK(Integer(answer.at("lower_bound").get<std::string>()) > 3);
  CHECK(contains(mdm(question).out, "no match within the limit on N"));
}

TEST_CASE("edge 6: a sweep ends at a stated size, with its bounds", "[cli]") {
  const Outcome outcome = mdm({"solve", "-", "--format", "json"}, endless());
  CHECK(outcome.exit_code == 3);
  const Json answer = Json::parse(outcome.out);
  CHECK(answer.at("status") == "feasible");
  CHECK(contains(answer.at("notes").dump(), "ended after 67108864 steps"));
  CHECK(outcome.max_rss_kib < 100 * megabyte); // no chain is kept without a proof
}

TEST_CASE("edge 7: a chain that is kept stays bounded", "[cli]") {
  const TemporaryFolder folder;
  // With sanitizers the sweeps to the stated size take minutes.
  const std::string steps = MDM_KEEPS_FREED_MEMORY != 0 ? "1000000" : "1000000000000";
  const Outcome outcome = mdm({"solve", "-", "--proof", folder / "p", "--max-steps", steps}, endless());
  CHECK(outcome.exit_code == 3);
  CHECK((MDM_KEEPS_FREED_MEMORY != 0 || outcome.max_rss_kib < 800 * megabyte));
  CHECK(contains(outcome.out, "the proof is of the bounds: at least "));
  CHECK(folder.entries() == 1);
  CHECK(std::filesystem::file_size(folder / "p") < (std::uintmax_t{250} << 20));
}

TEST_CASE("edge 8: the lines beside an endless one are written in batch, crosscheck and tradeoff", "[cli]") {
  const std::string suite = small + "\n" + endless() + "\n" + small + "\n";
  const Outcome batch = mdm({"batch"}, suite);
  CHECK(batch.exit_code == 3);
  REQUIRE(lines_of(batch.out).size() == 3);
  CHECK(contains(lines_of(batch.out)[1], "\"feasible\""));
  CHECK(contains(lines_of(batch.out)[2], "\"optimal\""));
  CHECK(batch.max_rss_kib < 100 * megabyte);

  const TemporaryFolder folder;
  const std::string answers = folder.write("a.csv", "id,quantities\nsmall,3 1\nendless,1 1 1\n");
  const Outcome judged = mdm({"crosscheck", "-", answers, "--format", "csv"}, suite);
  CHECK(lines_of(judged.out).size() == 4);
  CHECK(judged.max_rss_kib < 100 * megabyte);

  Arguments tradeoff{"tradeoff", "-", "--tolerances", "1", "--format", "csv"};
  if (MDM_KEEPS_FREED_MEMORY != 0) // with sanitizers the sweeps to the stated size take minutes
    tradeoff.insert(tradeoff.end(), {"--max-steps", "1000000"});
  const Outcome rows = mdm(tradeoff, endless());
  CHECK(rows.exit_code == 3);
  CHECK((MDM_KEEPS_FREED_MEMORY != 0 || rows.max_rss_kib < 100 * megabyte));
}

TEST_CASE("edge 17: a line that takes too much memory leaves the other lines of a batch alone", "[cli]") {
  if (MDM_KEEPS_FREED_MEMORY != 0)
    return;
  const TemporaryFolder folder;
  const std::string suite = folder.write("s.jsonl", small + "\n" + endless() + "\n" + small + "\n");
  const std::string command =
      "ulimit -v 250000; exec '" MDM_PROGRAM "' batch '" + suite + "' --proofs '" + (folder / "p") + "'";
  const Outcome outcome = Process("/bin/sh", {"-c", command}).end();
  INFO(outcome.err);
  CHECK(outcome.exit_code == 2);
  REQUIRE(lines_of(outcome.out).size() == 3);
  CHECK(contains(lines_of(outcome.out)[0], "\"optimal\""));
  CHECK(contains(lines_of(outcome.out)[1], "out of memory"));
  CHECK(contains(lines_of(outcome.out)[2], "\"optimal\""));
}

TEST_CASE("edge 18: where memory ends no file is left", "[cli]") {
  if (MDM_KEEPS_FREED_MEMORY != 0)
    return;
  const TemporaryFolder folder;
  std::string sand = "size_mm,mass\n";
  for (int i = 1; i <= 8000; ++i)
    sand +=
        fmt::format("{}.{},{}\n", i, std::string(900, '7'), i < 8000 ? "1." + std::string(900, '3') : "0");
  const std::string file = folder.write("sand.csv", sand);
  const std::string command =
      "ulimit -v 90000; exec '" MDM_PROGRAM "' solve '" + file + "' -o '" + (folder / "answer.txt") + "'";
  const Outcome outcome = Process("/bin/sh", {"-c", command}).end();
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "mdm: out of memory: give it more"));
  const std::filesystem::directory_iterator files(folder.path());
  CHECK(std::distance(begin(files), end(files)) == 1);
}

TEST_CASE("edge 9: what mdm writes it reads, whatever the id", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string id :
       {"ITEM: TIMESTEP", "size_a,b", "{", "fix x", "variable", "vtk DataFile Version 3.0",
        "radius_m,cumulative_number", "lower_mm,q", "12", "12 atoms", "#", ""}) {
    INFO(id);
    const std::string gradation =
        folder.write("g.json", R"({"id":")" + id + R"(","sizes":[1,2,3],"masses":[2,1,0]})");
    const std::string answer = folder.write("a.json", mdm({"solve", gradation, "--format", "json"}).out);
    CHECK(mdm({"verify", gradation, answer}).exit_code == 0);
    const std::string spread =
        folder.write("s.json", mdm({"solve", gradation, "--spread", "--format", "json"}).out);
    CHECK(mdm({"verify", gradation, spread}).exit_code == 0);
    for (const std::string format : {"csv", "lammps", "vtk", "yade", "diameters", "liggghts", "mercurydpm"}) {
      INFO(format);
      const Outcome file = mdm({"export", gradation, "--to", format, "--yes-units", "--quiet"});
      CHECK(file.exit_code == 0);
      Arguments verify = {"verify", gradation, folder.write("p", file.out), "--tolerance", "1%"};
      if (format == "yade" || format == "diameters")
        verify.insert(verify.end(), {"--size-unit", "m"});
      const Outcome verified = mdm(verify);
      INFO(file.out.substr(0, 300) << verified.err);
      CHECK(verified.exit_code == 0);
    }
  }
}

TEST_CASE("edge 10: a carriage return without a line feed hides no particle", "[cli]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.json", small);
  const std::string message = "a carriage return (CR) is there that no line feed (LF) follows";
  check_refused(mdm({"verify", gradation, "-"}, "size_mm,quantity\n# lab 7\r1.5,40\n2,1\n"),
                ":2: " + message);
  const std::string answers = folder.write("a.csv", "id,quantities\n# x\rsmall,6 2\nsmall,3 1\n");
  check_refused(mdm({"crosscheck", "-", answers}, small), ":2: " + message);
}

TEST_CASE("edge 11: no particle of a spread is on the open lower sieve", "[cli]") {
  // The mass 152 = 27 + 125 leaves the first size no place but 3.
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_mm,mass\n3,152\n9,0\n");
  const auto verify = [&](const std::string &first) {
    const std::string answer =
        R"({"schema":"mdm-answer-1","id":"g","status":"optimal","unit":"mm","particles":"2",)"
        R"("scale":{"chosen":"1"},"classes":[{"lower":"3","upper":"9","mass":"152","quantity":"2",)"
        R"("size":["4.2","4.3"],"sizes":[)" +
        first + R"(,["5","5"]]}]})";
    return mdm({"verify", gradation, "-"}, answer);
  };
  CHECK(verify(R"(["3","3.5"])").exit_code == 1);
  CHECK(contains(verify(R"(["3","3.5"])").out, "its sizes do not have its mass together"));
}

TEST_CASE("edge 12: a CSV answer leaves the size of no particles out", "[cli]") {
  const TemporaryFolder folder;
  const std::string suite = R"({"id":"gap","sizes":[1,2,3,4],"masses":[2,0,1,0]})";
  const Json best = Json::parse(mdm({"solve", "-", "--format", "json"}, suite).out);
  std::string sizes, counts;
  for (const Json &c : best.at("classes")) {
    counts += c.at("quantity").get<std::string>() + " ";
    sizes += c.at("size").is_null() ? "- " : c.at("size").at(1).get<std::string>() + " ";
  }
  const auto judge = [&](const std::string &of) {
    const std::string answers =
        folder.write("a.csv", "id,sizes_mm,quantities\ngap," + of + "," + counts + "\n");
    return mdm({"crosscheck", "-", answers, "--require-minimal", "--format", "csv", "--reasons"}, suite);
  };
  CHECK(judge(sizes).exit_code == 0);
  CHECK(contains(judge(sizes.substr(0, sizes.find('-'))).out, "write - for the size of a 0"));
}

TEST_CASE("edge 14: a LAMMPS data file has comments behind its counts", "[cli]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_m,mass\n1,1\n2,0\n");
  const Outcome outcome = mdm(
      {"verify", gradation, "-"},
      "title\n\n2 atoms # of glass\n1 atom types\n\nAtoms # sphere\n\n1 1 1.5 1 0 0 0\n2 1 1.5 1 2 0 0\n");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("edge 15: a box that is rounded is told", "[cli]") {
  const TemporaryFolder folder;
  const auto told = [&](const std::string &box) {
    const Outcome outcome = mdm({"export", "-", "--to", "lammps", "--box", box, "-o", folder / "x"}, small);
    CHECK(outcome.exit_code == 0);
    return outcome.err;
  };
  CHECK(contains(told("50.00000123x60"), "note: the box's side of 0.05000000123 m was rounded down to 0.05"));
  CHECK_FALSE(contains(told("50x60"), "rounded"));
}

TEST_CASE("edge 16: a journal knows what was asked, not the id alone", "[cli]") {
  const TemporaryFolder folder;
  const std::string journal = folder / "j", log = folder / "log";
  const std::string solver = "echo x >> '" + log + R"('; echo '{"quantities":[3,1]}')";
  const auto crosscheck = [&](const std::string &suite) {
    return mdm({"crosscheck", "-", "--solver", solver, "--journal", journal, "--format", "csv"}, suite);
  };
  CHECK(crosscheck(small).exit_code == 0);
  CHECK(crosscheck(small).exit_code == 0);
  CHECK(lines_of(read_file(log)).size() == 1);
  // The suite is corrected under the same id: the solver is asked anew.
  const std::string corrected = R"({"id":"small","sizes":[1,2,3],"masses":[9,1,0]})";
  CHECK(crosscheck(corrected).exit_code == 1);
  CHECK(lines_of(read_file(log)).size() == 2);
  CHECK(crosscheck(corrected).exit_code == 1);
  CHECK(lines_of(read_file(log)).size() == 2);
  // As ANSWERS each of its answers is judged against what was asked alone.
  const auto judged = [&](const std::string &suite) {
    return mdm({"crosscheck", "-", journal, "--format", "csv", "--reasons"}, suite);
  };
  const Outcome now = judged(corrected);
  CHECK(now.exit_code == 1);
  CHECK(lines_of(now.out).size() == 2);
  CHECK(contains(now.out, "small,not-a-match,4,"));
  CHECK(contains(now.err, "note: 1 answers of the journal are to other gradations"));
  CHECK(judged(small).exit_code == 0);
  const Outcome third = judged(R"({"id":"small","sizes":[1,2,3],"masses":[8,1,0]})");
  CHECK(third.exit_code == 1);
  CHECK(lines_of(third.out).size() == 2);
  CHECK(contains(third.out, "small,no-answer,,"));
  CHECK(contains(third.out, "the journal's answer is to another gradation with this id: ask again"));
  CHECK(contains(third.err, "note: 2 answers of the journal"));
  // A journal that does not say what was asked is no basis.
  folder.write("j", R"({"solver":"x","line":"1","id":"small","quantities":["3","1"],"sizes":[],"unit":"mm"})"
                    "\n");
  check_refused(crosscheck(small), "does not say which gradation was asked");
}
