// What reading a sheet assumes is said wherever the answer goes: by each command, in each form.

#include "run.hpp"

#include <set>

namespace notes_test {

using namespace cli_test;

namespace {

const std::string note = "Read as text with ; between cells";

std::string sheet(const TemporaryFolder &folder) {
  return folder.write("sheet.csv", "Siebweite [mm];Durchgang [%]\n2,0;100\n1,0;60\n0,5;20\n0,25;0\n");
}

enum class Place { out, err };

/// A command that reads the sheet, and where it says the note.
struct Row {
  Arguments command;
  Place place;
};

std::string shown(const Arguments &command) {
  std::string text;
  for (const std::string &word : command)
    text += word + " ";
  return text;
}

/// Every command that reads a gradation, in every form that it writes. CSV and the files of particles that
/// have no place for notes leave them to standard error.
std::vector<Row> rows(const TemporaryFolder &folder) {
  const std::string file = sheet(folder);
  const std::string sample = folder.write("sample.csv", "size_mm,quantity\n0.2,9\n0.4,90\n0.8,20\n1.5,3\n");
  const std::string limits =
      folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n1,50,90\n0.5,10,30\n");
  const std::string fine = folder.write("fine.csv", "size_mm,mass\n1,0\n0.5,3\n0.25,4\n");
  const std::string solution = folder.write("solution.txt", "q1 20\nq2 5\nq3 1\n");
  const std::string answer = folder / "sheet.answer.json";
  REQUIRE(mdm({"solve", file, "-o", answer}).exit_code == 0);
  std::vector<Row> all;
  const auto add_forms = [&all](const Arguments &command, Place csv) {
    for (const std::string form : {"text", "json", "csv"}) {
      Arguments words = command;
      words.insert(words.end(), {"--format", form});
      all.push_back({words, form == "csv" ? csv : Place::out});
    }
  };
  add_forms({"solve", file}, Place::err);
  add_forms({"solve", file, "--tolerance", "retained:2%"}, Place::err);
  add_forms({"solve", file, "--spread"}, Place::err);
  add_forms({"describe", file}, Place::out);
  add_forms({"describe", file, fine}, Place::err);
  add_forms({"judge", file, "--spec", limits}, Place::err);
  all.push_back({{"report", file}, Place::out});
  all.push_back({{"report", file, fine, "--spec", limits, "--format", "json"}, Place::out});
  add_forms({"crosscheck", file, "--solution", solution}, Place::err);
  add_forms({"blend", file, fine, "--spec", limits}, Place::err);
  add_forms({"tradeoff", file}, Place::err);
  add_forms({"verify", file, sample, "--tolerance", "100%"}, Place::err);
  add_forms({"published", "rounded", file}, Place::err);
  add_forms({"generate", "--curve", file}, Place::err);
  all.push_back({{"batch", file}, Place::out});
  all.push_back({{"batch", file, "--format", "csv"}, Place::err});
  all.push_back({{"convert", file}, Place::err});
  all.push_back({{"convert", file, "--format", "json"}, Place::err});
  all.push_back({{"convert", file, "--dry-run"}, Place::out});
  all.push_back({{"convert", file, "--dry-run", "--format", "json"}, Place::out});
  all.push_back({{"plot", file, "--format", "svg", "-o", "-"}, Place::out});
  all.push_back({{"plot", file, "--what", "counts", "--match", "--format", "svg", "-o", "-"}, Place::out});
  all.push_back({{"plot", file, "--beside", fine, "--format", "svg", "-o", "-"}, Place::out});
  all.push_back({{"pack", file, "--spread", "--at-least", "300"}, Place::err});
  for (const std::string to : {"csv", "liggghts", "lammps", "yade", "vtk"}) {
    all.push_back({{"export", file, "--to", to}, Place::err});
    all.push_back({{"export", answer, "--to", to}, Place::err});
  }
  return all;
}

/// The commands that read no gradation of a sheet: lines of suites are canonical, and their reading assumes
/// nothing.
const std::set<std::string> without_sheet = {"merge", "suite", "study", "completion"};

} // namespace

TEST_CASE("notes of reading go wherever the answer goes", "[cli]") {
  const TemporaryFolder folder;
  for (const Row &row : rows(folder)) {
    const Outcome outcome = mdm(row.command);
    INFO(shown(row.command));
    INFO(outcome.out.substr(0, 2000));
    INFO(outcome.err);
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 1));
    CHECK(contains(row.place == Place::out ? outcome.out : outcome.err, note));
  }
}

TEST_CASE("no command that reads sheets is without a row for its notes", "[cli]") {
  const TemporaryFolder folder;
  std::set<std::string> seen = without_sheet;
  for (const Row &row : rows(folder))
    seen.insert(row.command.front());
  const std::string message = mdm({"no-command"}).err;
  std::istringstream names(message.substr(message.find("there are ") + 10));
  std::size_t count = 0;
  for (std::string name; names >> name; ++count) {
    name.erase(name.find_last_not_of(",\n") + 1);
    INFO(name);
    CHECK(seen.count(name) == 1);
  }
  CHECK(count >= 16);
}

TEST_CASE("pictures beside a report have the notes of reading", "[cli]") {
  const TemporaryFolder folder;
  const std::string limits =
      folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n1,50,90\n");
  const std::string fine = folder.write("fine.csv", "size_mm,mass\n1,0\n0.5,3\n0.25,4\n");
  for (const Arguments &command : {Arguments{"tradeoff", sheet(folder)},
                                   {"judge", sheet(folder), "--spec", limits},
                                   {"blend", sheet(folder), fine, "--spec", limits}}) {
    Arguments words = command;
    words.insert(words.end(), {"--plot", folder / "a.svg"});
    INFO(shown(command));
    CHECK(mdm(words).exit_code == 0);
    CHECK(contains(read_file(folder / "a.svg"), note));
  }
}

TEST_CASE("the notes of an answer go with its particles", "[cli]") {
  const TemporaryFolder folder;
  const std::string answer = folder / "a.json";
  REQUIRE(mdm({"solve", sheet(folder), "-o", answer}).exit_code == 0);
  const Outcome told = mdm({"export", answer, "--to", "csv"});
  CHECK(contains(told.err, "note: " + note));
  const Outcome quiet = mdm({"export", answer, "--to", "csv", "--quiet"});
  CHECK(quiet.out == told.out);
  CHECK(quiet.err.empty());
}

} // namespace notes_test
