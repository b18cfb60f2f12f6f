// mdm-check --suite: all certificates of a folder, a summary, and the worst exit code. Those of streams are
// in proof_stream_test.cpp.

#include "catch.hpp"
#include "program.hpp"

namespace suite_test {

using namespace mdm_check_test;

namespace {

std::string certificate(const std::string &file) {
  return read_file(std::filesystem::path(MDM_CERTIFICATES_DIR) / file);
}

const std::string line = R"({"id": "a", "sizes": [1, 2, 3], "masses": [2, 1, 0]})";
const std::string other_line = R"({"id": "b", "sizes": [1, 2, 3], "masses": [2, 9, 0]})";

const std::string exact_question = "the smallest number of particles that matches exactly (mass law x^3)";

/// A suite and its folder.
struct Suite {
  TemporaryFolder folder;
  std::string file = (folder.path() / "suite.jsonl").string();
  std::string proofs = (folder.path() / "proofs").string();

  explicit Suite(const std::string &lines) {
    std::filesystem::create_directory(proofs);
    write_file(file, lines);
  }
  std::string add(const std::string &name, const std::string &text) const {
    return write_file(std::filesystem::path(proofs) / name, text).string();
  }
  /// The last line; all that are accepted were asked the same.
  std::string summary(const std::string &counts) const {
    const std::string accepted = counts.substr(0, counts.find(' '));
    const std::string question = "; " + accepted + " accepted as " + exact_question;
    return file + ": " + counts + (accepted == "0" ? "" : question) + "\n";
  }
};

} // namespace

TEST_CASE("certificates are checked against the lines that their names begin with", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s(line + "\r\n \n" + line + "\n");
  s.add("000001-a.proof", proof);
  s.add("3.proof", proof);
  s.add("notes.txt", "of no concern");
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == s.summary("2 accepted, 0 refused, 0 malformed, 0 missing"));
  CHECK(outcome.err.empty());
  const Outcome verbose = run({"--suite", s.file, s.proofs, "--verbose"});
  CHECK(verbose.out.find(s.file + ":1\" exactly (") != std::string::npos);
  CHECK(verbose.out.find(s.file + ":3\" exactly (") != std::string::npos);
  CHECK(run({"--suite", "-", s.proofs}, s.file).exit_code == 0);
}

TEST_CASE("the exit code of a suite is that of the worst certificate", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s(line + "\n" + other_line + "\n" + line + "\n");
  s.add("1.proof", proof);
  const std::string wrong = s.add("2-b.proof", proof);
  const Outcome refused = run({"--suite", s.file, s.proofs});
  CHECK(refused.exit_code == 1);
  CHECK(refused.out.find("refused: " + wrong + ": ") == 0);
  CHECK(refused.out.find("missing: " + s.file + ":3: ") != std::string::npos);
  CHECK(refused.out.find(s.summary("1 accepted, 1 refused, 0 malformed, 1 missing")) != std::string::npos);
  const std::string none = s.add("3-c.proof", "none");
  const Outcome malformed = run({"--suite", s.file, s.proofs});
  CHECK(malformed.exit_code == 2);
  CHECK(malformed.out.find("malformed: " + none + ":1: ") != std::string::npos);
}

TEST_CASE("a certificate without a line, and a line that is no gradation, are malformed", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  for (const char *name : {"0.proof", "2-a.proof", "a.proof", "1a.proof", "99999999999999999999.proof"}) {
    const Suite s(line + "\n");
    s.add("1.proof", proof);
    const std::string path = s.add(name, proof);
    const Outcome outcome = run({"--suite", s.file, s.proofs});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "malformed: " + path + ": begins with the number of no line of '" + s.file + "'\n" +
                             s.summary("1 accepted, 0 refused, 1 malformed, 0 missing"));
  }
  const Suite s("{\n");
  s.add("1.proof", proof);
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("malformed: " + s.file + ":1: '") == 0);
}

TEST_CASE("every certificate of one line is checked", "[checker]") {
  const Suite s(line + "\n");
  s.add("1-a.proof", certificate("accepted/sphere_two_classes.proof"));
  s.add("1-b.proof", "older");
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("1 accepted, 0 refused, 1 malformed") != std::string::npos);
}

TEST_CASE("threads change nothing of the verdicts and their order", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  std::string lines;
  for (int i = 0; i < 500; ++i)
    lines += (i % 7 == 3 ? other_line : line) + "\n";
  const Suite s(lines);
  for (int i = 1; i <= 500; ++i)
    if (i % 11 != 0)
      s.add(std::to_string(i) + ".proof", i % 5 == 0 ? proof + "x" : proof);
  const Outcome one = run({"--suite", s.file, s.proofs, "--verbose"});
  CHECK(one.exit_code == 2);
  for (const std::vector<std::string> &threads :
       std::vector<std::vector<std::string>>{{"-j", "2"}, {"-j7"}, {"-j", "1024"}}) {
    std::vector<std::string> arguments = {"--suite", s.file, s.proofs, "--verbose"};
    arguments.insert(arguments.end(), threads.begin(), threads.end());
    const Outcome more = run(arguments);
    CHECK(more.exit_code == one.exit_code);
    CHECK(more.out == one.out);
  }
  for (const char *threads : {"0", "1025", "x", "-1", "", "99999999999999999999"})
    CHECK(run({"--suite", s.file, s.proofs, "-j", threads}).err.find("mdm-check: -j: ") == 0);
  CHECK(run({"--suite", s.file, s.proofs, "-j"}).exit_code == 2);
}

TEST_CASE("without a suite, certificates are checked against the gradations beside them", "[checker]") {
  const std::string proof = certificate("accepted/sphere_two_classes.proof");
  const Suite s("");
  s.add("1-a.proof", proof);
  s.add("1-a.gradation", "size_mm,mass\n1,2\n2,1\n3,0\n");
  CHECK(run({"--suite", s.proofs}).exit_code == 0);
  const std::string alone = s.add("2-b.gradation", line), other = s.add("3-c.proof", proof);
  const Outcome outcome = run({"--suite", s.proofs});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find("missing: " + alone + ": ") != std::string::npos);
  CHECK(outcome.out.find("missing: " + other + ": ") != std::string::npos);
  CHECK(outcome.out.find("1 accepted, 0 refused, 0 malformed, 2 missing") != std::string::npos);
}

TEST_CASE("a suite or a folder that cannot be read, or has nothing, is refused", "[checker]") {
  const Suite s("\n");
  const std::string missing = s.folder.path() / "missing";
  for (const std::vector<std::string> &arguments :
       std::vector<std::vector<std::string>>{{"--suite"},
                                             {"--suite", "-"},
                                             {"--suite", s.file, s.proofs, s.proofs},
                                             {"--suite", s.file, missing},
                                             {"--suite", missing, s.proofs},
                                             {"--suite", s.file, s.file},
                                             {"--suite", s.proofs, s.proofs},
                                             {"--suite", s.file, s.proofs},
                                             {"--suite", s.proofs},
                                             {"--suite", s.file, s.proofs, "--print"}}) {
    const Outcome outcome = run(arguments);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

// ---- Questions and answers ----

namespace {

/// Anything at all matches, so that one particle does.
const std::string trivial =
    "mdm-certificate 1\nlaw 3\nretained 100\nparticles 1\nclass 2 1 27 3 3\nleaf 1 N 1 n\nend\n";

/// That of the certificate sphere_two_classes to `line`, with another text in some places.
std::string answer(const std::string &from = "", const std::string &to = "") {
  std::string text =
      R"({"schema": "mdm-answer-1", "id": "a", "status": "optimal", "particles": "4", "lower_bound": "4", )"
      R"("unit": "mm", "classes": [)"
      R"({"lower": "1", "upper": "2", "mass": "2", "quantity": "3", "size": ["1.882072057762", "1.882072057763"]}, )"
      R"({"lower": "2", "upper": "3", "mass": "1", "quantity": "1", "size": ["2.154434690031", "2.154434690032"]}], )"
      R"("scale": null, "tolerance": null, "notes": [], "versions": {"mdm": "1"}})";
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return from.empty() ? text : text.replace(at, from.size(), to);
}

} // namespace

TEST_CASE("the last line says how often each question was proved", "[checker]") {
  const Suite s(line + "\n" + line + "\n" + line + "\n");
  s.add("1.proof", certificate("accepted/sphere_two_classes.proof"));
  s.add("2.proof", trivial);
  s.add("3.proof", trivial);
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == s.file +
                           ": 3 accepted, 0 refused, 0 malformed, 0 missing; 2 accepted as the smallest "
                           "number of particles that matches within a tolerance (retained within 100% of "
                           "the total mass; mass law x^3); 1 accepted as " +
                           exact_question + "\n");
}

TEST_CASE("of many questions the most frequent are named and the others counted", "[checker]") {
  std::string lines;
  for (int i = 1; i <= 15; ++i)
    lines += line + "\n";
  const Suite s(lines);
  for (int i = 1; i <= 15; ++i) {
    std::string proof = trivial;
    if (i > 1)
      proof.replace(proof.find("100"), 3, i == 2 ? "100" : std::to_string(100 - i));
    s.add(std::to_string(i) + ".proof", proof);
  }
  const Outcome outcome = run({"--suite", s.file, s.proofs});
  CHECK(outcome.out.find("; 2 accepted as the smallest number of particles that matches within a tolerance "
                         "(retained within 100% of") != std::string::npos);
  CHECK(outcome.out.find("accepted of 2 other questions (--verbose)\n") != std::string::npos);
}

TEST_CASE("a proof of another question than the answer's is noticed", "[checker]") {
  const Suite s(line + "\n" + line + "\n");
  s.add("1.proof", certificate("accepted/sphere_two_classes.proof"));
  const std::string other = s.add("2.proof", trivial);
  const std::string answers =
      write_file(s.folder.path() / "answers.jsonl", answer() + "\n\n" + answer() + "\n").string();
  const Outcome outcome = run({"--suite", s.file, s.proofs, "--answers", answers});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out == "different: " + answers + ":3: not as " + other +
                           " proves: the answer is that 4 particles are the smallest match\n" +
                           s.summary("1 accepted, 0 refused, 0 malformed, 0 missing, 1 different"));
}

TEST_CASE("answers are compared in number, classes, quantities, sizes and question", "[checker]") {
  const Suite s(line + "\n");
  s.add("1.proof", certificate("accepted/sphere_two_classes.proof"));
  const auto outcome = [&](const std::string &text) {
    const std::string answers = write_file(s.folder.path() / "answers", text).string();
    return run({"--suite", s.file, s.proofs, "--answers", answers});
  };
  CHECK(outcome(answer() + "\n").exit_code == 0);
  const std::vector<std::pair<std::string, std::string>> changes = {
      {R"("particles": "4")", R"("particles": "3")"},
      {R"("optimal")", R"("none")"},
      {R"("optimal")", R"("error")"},
      {R"("lower_bound": "4")", R"("question": "at least 4 particles", "lower_bound": "4")"},
      {R"("quantity": "3")", R"("quantity": "2")"},
      {R"("quantity": "1")", R"("quantity": "0")"},
      {"1.882072057763", "1.882072057764"},
      {R"(["2.154434690031", "2.154434690032"])", "null"},
      {R"("lower": "1")", R"("lower": "0")"},
      {R"("upper": "3")", R"("upper": "4")"},
      {R"("tolerance": null)",
       R"("tolerance": {"asked": ["total:200%"], "band": null, "retained": [], "passing": [], "total": "2"})"}};
  for (const auto &[from, to] : changes) {
    INFO(to);
    const Outcome changed = outcome(answer(from, to));
    CHECK(changed.exit_code == 1);
    CHECK(changed.out.starts_with("different: "));
  }
  const Outcome less = outcome(answer(R"("optimal")", R"("feasible")"));
  CHECK(less.exit_code == 0); // the bound of a search that was ended is proved, too
}

TEST_CASE("the tolerance of an answer is compared as bounds on shares", "[checker]") {
  const Suite s(line + "\n");
  s.add("1.proof", trivial);
  const auto code = [&](const std::string &bounds, const std::string &words) {
    const std::string text =
        R"({"status": "optimal", "particles": "1", "lower_bound": "1", "classes": [)"
        R"({"lower": "1", "upper": "2", "quantity": "0", "size": null}, )"
        R"({"lower": "2", "upper": "3", "quantity": "1", "size": ["3", "3"]}], "question": ")" +
        words + R"(", "tolerance": {"asked": ["retained:100%"], "band": null, )" + bounds + "}}";
    const std::string answers = write_file(s.folder.path() / "answers", text).string();
    return run({"--suite", s.file, s.proofs, "--answers", answers}).exit_code;
  };
  const std::string all = R"("retained": [["0", "1"], ["0", "1"]], "passing": [], "total": null)";
  CHECK(code(all, "within retained:100%") == 0);
  CHECK(code(R"("retained": [], "passing": [["0", "1"], ["1/3", "1"]], "total": "2")",
             "within retained:100%") == 0);
  CHECK(code(R"("retained": [["0", "1"], ["1/3", "1"]], "passing": [], "total": null)",
             "within retained:100%") == 1);
  CHECK(code(R"("retained": [], "passing": [["0", "2/3"], ["0", "1"]], "total": null)",
             "within retained:100%") == 1);
  CHECK(code(R"("retained": [], "passing": [], "total": "1/10")", "within retained:100%") == 1);
  CHECK(code(all, "within retained:100%; at least 2 particles") == 1);
  CHECK(code(all, "") == 1);
}

TEST_CASE("answers in CSV are compared, and answers that are too many, too few or none are malformed",
          "[checker]") {
  std::string named = line;
  named.replace(named.find("\"a\""), 3, "\"a,b\"");
  const Suite s(named + "\n" + named + "\n");
  s.add("1.proof", certificate("accepted/sphere_two_classes.proof"));
  s.add("2.proof", certificate("accepted/sphere_two_classes.proof"));
  const std::string header = "id,class,lower_mm,upper_mm,share_percent,quantity,size_lo_mm,size_hi_mm\n",
                    rows = "\"a,b\",1,1,2,66.7,3,1.882072057762,1.882072057763\n"
                           "\"a,b\",2,2,3,33.3,1,2.154434690031,2.154434690032\n";
  const auto outcome = [&](const std::string &text) {
    const std::string answers = write_file(s.folder.path() / "answers", text).string();
    return run({"--suite", s.file, s.proofs, "--answers", answers});
  };
  CHECK(outcome(header + rows + rows).exit_code == 0);
  std::string of_matches = header;
  of_matches.insert(header.find("share"), "match_");
  CHECK(outcome(of_matches + rows + rows).exit_code == 0);
  std::string wrong = rows;
  wrong.replace(wrong.find(",3,1.88"), 2, ",2");
  CHECK(outcome(header + rows + wrong).out.find("class 1 has 2 particles") != std::string::npos);
  CHECK(outcome(header + rows + wrong).exit_code == 1);
  CHECK(outcome(header + rows).out.find("missing: " + s.file + ":2: no answer in ") != std::string::npos);
  CHECK(outcome(header + rows).exit_code == 1);
  CHECK(outcome(header + rows + rows + rows).out.find("no line of ") != std::string::npos);
  for (const std::string &text :
       {header + rows + rows + rows, rows + rows, answer() + "\n{", std::string("[]"),
        header + rows + "a,1,1\n", answer(R"("4")", R"("4.5")") + "\n", std::string()})
    CHECK(outcome(text).exit_code == 2);
}

TEST_CASE("a line that is no gradation has no rows of CSV", "[checker]") {
  const std::string negative = R"({"id": "a", "sizes": [1, 2, 3], "masses": [2, -1, 0]})",
                    header = "id,class,lower_mm,upper_mm,share_percent,quantity,size_lo_mm,size_hi_mm\n",
                    rows = "a,1,1,2,66.7,3,1.882072057762,1.882072057763\n"
                           "a,2,2,3,33.3,1,2.154434690031,2.154434690032\n";
  const Suite s("nonsense\n" + negative + "\n" + line + "\n");
  s.add("3.proof", certificate("accepted/sphere_two_classes.proof"));
  const std::string answers = write_file(s.folder.path() / "answers", header + rows).string();
  const Outcome outcome = run({"--suite", s.file, s.proofs, "--answers", answers});
  CHECK(outcome.out.find("1 accepted, 0 refused, 0 malformed, 2 missing, 0 different") != std::string::npos);
  CHECK(outcome.exit_code == 1);
}

TEST_CASE("an answer in another unit is different", "[checker]") {
  const Suite s(line + "\n");
  s.add("1.proof", certificate("accepted/sphere_two_classes.proof"));
  const std::string rows = "a,1,1,2,66.7,3,1.882072057762,1.882072057763\n"
                           "a,2,2,3,33.3,1,2.154434690031,2.154434690032\n",
                    header = "id,class,lower_um,upper_um,share_percent,quantity,size_lo_um,size_hi_um\n";
  for (const std::string &text : {header + rows, answer(R"("unit": "mm")", R"("unit": "um")") + "\n"}) {
    const std::string answers = write_file(s.folder.path() / "answers", text).string();
    const Outcome outcome = run({"--suite", s.file, s.proofs, "--answers", answers});
    INFO(outcome.out);
    CHECK(outcome.out.find("the answer has lengths in 'um', the gradation in mm") != std::string::npos);
    CHECK(outcome.exit_code == 1);
  }
}

TEST_CASE("answers need a suite", "[checker]") {
  const Suite s(line + "\n");
  CHECK(run({"--suite", s.proofs, "--answers", s.file}).exit_code == 2);
  CHECK(run({"--suite", s.file, s.proofs, "--answers"}).exit_code == 2);
  CHECK(run({"--suite", s.file, s.proofs, "--answers", s.file + "x"}).exit_code == 2);
  CHECK(run({"--answers", s.file, s.file, s.proofs}).exit_code == 2);
}

} // namespace suite_test
