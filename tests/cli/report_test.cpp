// mdm report as a whole program.

#include "answer.hpp"

namespace report_test {

using namespace cli_test;

namespace {

const std::string sand =
    "size_mm,passing_percent\n9.5,100\n4.75,97.3\n2.36,88\n1.18,70\n0.6,45\n0.3,18\n0.15,4\n";

Arguments with(Arguments some, const std::string &last) {
  some.push_back(last);
  return some;
}

} // namespace

TEST_CASE("a report is written as HTML and JSON, whole or not at all", "[report]") {
  const TemporaryFolder folder;
  folder.write("a.csv", sand);
  const Arguments asked = {"report",  folder / "a.csv",   "--spec", "astm-c33-fine", "--client", "A & B",
                           "--field", "Project=Quay = 2", "-o"};
  CHECK(mdm(with(asked, folder / "r.html")).exit_code == 0);
  const std::string html = read_file(folder / "r.html");
  CHECK(contains(html,
                 "Client</th><td>A &amp; B</td></tr>\n<tr><th scope=\"row\">Project</th><td>Quay = 2</td>"));
  CHECK(contains(html, "a: pass"));
  CHECK(mdm(with(asked, folder / "r.json")).exit_code == 0);
  const Json json = Json::parse(read_file(folder / "r.json"));
  CHECK(json.at("judgement").at("samples")[0].at("verdict") == "pass");
  CHECK(json.at("descriptions")[0].at("id") == "a");
  check_refused(mdm(with(asked, folder / "r.doc")), "let OUT end in .html, .pdf or .json");
  check_refused(mdm({"report", folder / "a.csv", folder / "none.csv", "-o", folder / "s.html"}), "none.csv");
  CHECK(folder.entries() == 3);
}

TEST_CASE("a report of a sample that misses a limit is exit 1", "[report]") {
  const Outcome outcome = mdm({"report", "-", "--spec", "superpave-19"}, sand);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.out, "stdin: fail"));
}

TEST_CASE("a report in German has German words and numbers", "[report]") {
  const std::string gravelly = "size_mm,passing_percent\n9.5,100\n2.36,70\n2,60\n0.063,10\n0.02,0\n";
  const Outcome outcome =
      mdm({"report", "-", "--language", "de", "--client", "Hafen", "--spec", "superpave-19"}, gravelly);
  CHECK(outcome.exit_code == 1);
  for (const char *expected :
       {"<html lang=\"de\">", "<h1>Bericht zur Korngrößenverteilung</h1>", "Auftraggeber</th><td>Hafen</td>",
        "stdin: nicht erfüllt", ">2,36<", "grSa, kiesiger Sand", "Feinkorn"}) {
    INFO(expected);
    CHECK(contains(outcome.out, expected));
  }
  CHECK_FALSE(contains(outcome.out, "not available"));
  check_refused(mdm({"report", "-", "--language", "de", "--format", "json"}, sand), "JSON has none");
  check_refused(mdm({"report", "-", "--language", "fr"}, sand), "--language");
}

TEST_CASE("what is wrong with a report is refused", "[report]") {
  check_refused(mdm({"report", "-", "--field", "Project"}, sand), "--field: 'Project' is no NAME=VALUE");
  check_refused(mdm({"report", "-", "--spec", "none"}, sand), "specifications that come with mdm");
  check_refused(mdm({"report", "-", "-"}, sand), "standard input is one file");
  check_refused(mdm({"report", "-", "--rounding", "none"}, sand), "--rounding is about verdicts");
  check_refused(mdm({"report", "-", "--liquid-limit", "20"}, sand), "go together");
}

TEST_CASE("a PDF of a report has its texts", "[report]") {
  const TemporaryFolder folder;
  const Outcome outcome = mdm({"report", "-", "--client", "Harbour", "-o", folder / "r.pdf"}, sand);
  if (outcome.exit_code != 0) {
    check_refused(outcome, "a PDF needs the program weasyprint");
    CHECK(folder.entries() == 0);
    return;
  }
  CHECK(read_file(folder / "r.pdf").starts_with("%PDF"));
  const std::string text = folder / "r.txt";
  if (std::system(("pdftotext " + (folder / "r.pdf") + " " + text + " 2>/dev/null").c_str()) == 0)
    for (const char *part : {"Grain size report", "Harbour", "AASHTO M 145", "97.3"})
      CHECK(contains(read_file(text), part));
}

TEST_CASE("samples of one name have those of their files", "[report]") {
  const TemporaryFolder one, other;
  const std::string a = one.write("sand.csv", sand), b = other.write("sand.csv", sand);
  const Outcome report = mdm({"report", a, b, a});
  CHECK(contains(report.out, "<caption>" + a + "</caption>"));
  CHECK(contains(report.out, "<caption>" + b + "</caption>"));
  CHECK(contains(report.out, "<caption>" + a + " (2)</caption>"));
  CHECK(contains(mdm({"describe", a, b}).out, "\n  " + b + "  SP"));
  CHECK(contains(mdm({"judge", a, b, "--spec", "astm-c33-fine", "--format", "csv"}).out, "\n" + b + ","));
  CHECK(mdm({"plot", a, "--beside", b, "-o", one / "p.svg"}).exit_code == 0);
  CHECK(contains(read_file(one / "p.svg"), ">" + b + "<"));
}

} // namespace report_test
