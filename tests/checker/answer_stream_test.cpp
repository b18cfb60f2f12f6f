// mdm-check --suite with a stream of answers' certificates, each behind its sample, made by hand.

#include "catch.hpp"
#include "program.hpp"

namespace answer_stream_test {

using namespace mdm_check_test;

namespace {

const std::string line = R"({"id": "a", "sizes": [1, 2, 3], "masses": [2, 1, 0]})";
const std::string other_line = R"({"id": "b", "sizes": [1, 2, 3], "masses": [2, 9, 0]})";
const std::string sample = "size_mm,quantity\n1.5,2\n2.5,1\n";
const std::string certificate = // the example of section 12
    "mdm-certificate sample 1\nlaw 1\nretained 15\nparticles 3\nclass 1 2 600/11\n"
    "class 2 1 500/11\nretained-error 1 12.1212 12.1213\n"
    "passing-error 1 12.1212 12.1213\ntotal-error 24.2424 24.2425\n"
    "conditions yes yes yes no\nverdict match\nend\n";
/// Another answer to the line, and that it does not match.
const std::string other_sample = "size_mm\n1.5\n2.5\n",
                  other_certificate =
                      "mdm-certificate sample 1\nlaw 1\nretained 15\nparticles 2\nclass 1 1 75/2\n"
                      "class 2 1 125/2\nretained-error 1 29.1666 29.1667\n"
                      "passing-error 1 29.1666 29.1667\ntotal-error 58.3333 58.3334\n"
                      "conditions yes yes yes no\nverdict class 1 37.5 37.5 least 51.6666\nend\n";

/// A line of the index.
struct Entry {
  std::uint64_t number, answer;
  std::size_t offset, sample, length;
};

std::string text_of(const Entry &e) {
  std::string text;
  for (const std::size_t n : {std::size_t{e.number}, std::size_t{e.answer}, e.offset, e.sample, e.length})
    text += (text.empty() ? "" : " ") + std::to_string(n);
  return text + "\n";
}

struct Part {
  std::uint64_t number, answer;
  std::string sample, certificate;
};

/// A suite with a stream of answers' certificates and its index.
struct Streamed {
  TemporaryFolder folder;
  std::string suite, stream, entries;

  Streamed(const std::string &lines, const std::vector<Part> &parts)
      : suite(folder.write("suite.jsonl", lines)), stream((folder.path() / "all.proofs").string()) {
    std::string text;
    for (const Part &part : parts) {
      entries +=
          text_of({part.number, part.answer, text.size(), part.sample.size(), part.certificate.size()});
      text += part.sample + part.certificate;
    }
    folder.write("all.proofs", text);
    write_index(entries);
  }
  void write_index(const std::string &of, const std::string &header = "mdm-proofs sample 1\n") const {
    folder.write("all.proofs.index", header + of);
  }
  Outcome check(const std::vector<std::string> &more = {}) const {
    std::vector<std::string> arguments = {"--suite", suite, stream};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

void check_outcome(const Streamed &s, int exit_code, const std::string &reason, const std::string &counts) {
  const Outcome outcome = s.check();
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(has(outcome.out, reason));
  CHECK(has(outcome.out, s.suite + ": " + counts));
  CHECK(outcome.err.empty());
}

/// The index is refused, and nothing of the stream is judged.
void check_index(const std::string &entries, const std::string &reason) {
  const Streamed s(line + "\n", {{1, 1, sample, certificate}});
  s.write_index(entries);
  check_outcome(s, 2, "malformed: " + s.stream + reason, "0 accepted, 0 refused, 1 malformed");
}

} // namespace

TEST_CASE("the certificates of answers in a stream are checked, one line each", "[checker]") {
  const Streamed s(
      line + "\n\n" + line + "\n",
      {{1, 1, sample, certificate}, {1, 2, other_sample, other_certificate}, {3, 1, sample, certificate}});
  for (const char *const threads : {"-j1", "-j3"}) {
    const Outcome outcome = s.check({"--verbose", threads});
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.rfind("accepted: the 3 particles of \"" + s.stream + " (sample of line 1)\" match \"" +
                                s.suite + ":1\" within a tolerance; ",
                            0) == 0);
    CHECK(has(outcome.out, "\naccepted: the 2 particles of \"" + s.stream +
                               " (sample of line 1, answer 2)\" do not match \"" + s.suite +
                               ":1\" within a tolerance: class 1 holds 37.5 %, and at least 51.6666 % "));
    CHECK(has(outcome.out, " (sample of line 3)\" match \"" + s.suite + ":3\" "));
    CHECK(has(outcome.out, "\n" + s.suite + ": 3 accepted, 0 refused, 0 malformed, 0 missing; 3 accepted "));
  }
  check_outcome(s, 0, "", "3 accepted, 0 refused, 0 malformed, 0 missing");
}

TEST_CASE("a line whose answer has no certificate in a stream is missing", "[checker]") {
  const Streamed s(line + "\n" + line + "\n", {{2, 2, sample, certificate}});
  check_outcome(s, 1, "missing: " + s.suite + ":1: no certificate in the stream\n",
                "1 accepted, 0 refused, 0 malformed, 1 missing");
}

TEST_CASE("a changed certificate, and that of another answer or gradation, are refused", "[checker]") {
  std::string changed = certificate;
  changed.replace(changed.find("particles 3"), 11, "particles 4");
  const std::string before = "refused: ", all = "1 accepted, 1 refused, 0 malformed, 0 missing";
  const auto check = [&](const std::string &second_line, const Part &second) {
    const Streamed s(line + "\n" + second_line + "\n", {{1, 1, sample, certificate}, second});
    check_outcome(s, 1, before + s.stream + " (of line 2): ", all);
  };
  check(line, {2, 1, sample, changed});
  check(line, {2, 1, sample, other_certificate});
  check(line, {2, 1, other_sample, certificate});
  check(line, {2, 1, "size_mm,quantity\n1.5,2\n2.6,1\n", certificate});
  check(other_line, {2, 1, sample, certificate});
  const Streamed two(line + "\n", {{1, 1, sample, certificate}, {1, 2, sample, other_certificate}});
  check_outcome(two, 1, before + two.stream + " (of line 1, answer 2): ", all);
}

TEST_CASE("what cannot be read in a stream of answers is malformed, and the rest is judged", "[checker]") {
  const auto check = [&](const std::string &first_line, const Part &first, const std::string &reason) {
    const Streamed s(first_line + "\n" + line + "\n", {first, {2, 1, sample, certificate}});
    const Outcome outcome = s.check();
    INFO(outcome.out);
    CHECK(outcome.out.rfind("malformed: " + (reason[0] == ':' ? s.suite : s.stream) + reason, 0) == 0);
    check_outcome(s, 2, "", "1 accepted, 0 refused, 1 malformed, 0 missing");
  };
  check(R"({"sizes": [1, 2, 3], "masses": [2, 1]})", {1, 1, sample, certificate}, ":1: ");
  check("no gradation", {1, 1, sample, certificate}, ":1: ");
  check(line, {1, 1, "size_mm\n1.5\nx\n", certificate}, " (sample of line 1):3: ");
  check(line, {1, 1, "sizes\n1.5\n", certificate}, " (sample of line 1):1: ");
  check(line, {1, 1, sample, "mdm-certificate 1\nlaw 3\n"}, " (of line 1):1: ");
  check(line, {1, 1, sample, sample}, " (of line 1):1: ");
  check(line, {1, 1, sample, certificate + "\n"}, " (of line 1):");
}

TEST_CASE("wrong lengths give no sample a part of its certificate", "[checker]") {
  const Streamed s(line + "\n", {{1, 1, sample, certificate}});
  for (const int shift : {-1, 1}) {
    const auto by = static_cast<std::size_t>(shift);
    s.write_index(text_of({1, 1, 0, sample.size() + by, certificate.size() - by}));
    check_outcome(s, 2, "malformed: " + s.stream, "0 accepted, 0 refused, 1 malformed");
  }
}

TEST_CASE("a stream of answers that is cut or goes on is malformed", "[checker]") {
  const Streamed s(line + "\n" + line + "\n", {{1, 1, sample, certificate}, {2, 1, sample, certificate}});
  const std::string whole = sample + certificate;
  const auto check = [&](const std::string &stream, const std::string &reason, const std::string &accepted) {
    s.folder.write("all.proofs", stream);
    check_outcome(s, 2, "malformed: " + s.stream + reason, accepted + " accepted, 0 refused, 1 malformed");
  };
  check("", " (sample of line 1): the stream ends before its ", "0");
  check(whole.substr(0, sample.size() + 9), " (of line 1): the stream ends before its ", "0");
  check(whole, " (sample of line 2): the stream ends before its ", "1");
  check(whole + sample.substr(0, 3), " (sample of line 2): the stream ends before its ", "1");
  check(whole + sample, " (of line 2): the stream ends before its ", "1");
  check(whole + whole + "x", ": goes on behind the ", "2");
}

TEST_CASE("an index of answers that lies is malformed", "[checker]") {
  const std::size_t s = sample.size(), c = certificate.size();
  const std::string entry = text_of({1, 1, 0, s, c});
  check_index(text_of({1, 1, 1, s, c}), ".index:2: offset 1, where the certificate before ends at 0");
  check_index(text_of({0, 1, 0, s, c}), ".index:2: line 0 does not ascend");
  check_index(text_of({1, 0, 0, s, c}), ".index:2: line 1 does not ascend");
  check_index(text_of({2, 1, 0, s, c}), ".index:2: no line 2 in ");
  check_index(text_of({1, 1, 0, 0, c}), ".index:2: a sample has 1 byte to 256 MiB");
  check_index(text_of({1, 1, 0, s, 0}), ".index:2: a certificate has 1 byte to 256 MiB");
  check_index(text_of({1, 1, 0, std::size_t{1} << 40U, c}), ".index:2: a sample has 1 byte to 256 MiB");
  check_index(entry + text_of({1, 1, s + c, s, c}), ".index:3: line 1 does not ascend");
  for (const char *wrong :
       {"1 0 29\n", "1 1 0 29\n", "1 1 0 29 ", "1 1 0 29 5 6\n", "01 1 0 29 5\n", "1 -1 0 29 5\n", "\n",
        "1 1 0 29 x\n", "1 1  0 29\n", "\xFF\n", "1 1 0 29 1000000000000000000\n", "1 1 0 29 5"})
    check_index(wrong, ".index:2: no five numbers");
  const Streamed several(line + "\n" + line + "\n",
                         {{2, 1, sample, certificate}, {1, 1, sample, certificate}});
  check_outcome(several, 2, "malformed: " + several.stream + ".index:3: line 1 does not ascend",
                "0 accepted, 0 refused, 1 malformed");
  const Streamed twice(line + "\n", {{1, 2, sample, certificate}, {1, 2, sample, certificate}});
  check_outcome(twice, 2, "malformed: " + twice.stream + ".index:3: line 1, answer 2 does not ascend",
                "0 accepted, 0 refused, 1 malformed");
}

TEST_CASE("an index of answers with another header is malformed", "[checker]") {
  const Streamed s(line + "\n", {{1, 1, sample, certificate}});
  for (const char *header :
       {"", "mdm-proofs sample 2\n", "mdm-proofs sample 1 \n", "mdm-certificate sample 1\n"}) {
    s.write_index(s.entries, header);
    check_outcome(s, 2, "malformed: " + s.stream + ".index:1: the first line is not ", "0 accepted");
  }
  s.write_index(s.entries, "mdm-proofs 1\n");
  check_outcome(s, 2, "malformed: " + s.stream + ".index:2: no three numbers", "0 accepted");
  s.write_index("1 0 " + std::to_string(sample.size() + certificate.size()) + "\n", "mdm-proofs 1\n");
  check_outcome(s, 2, "malformed: " + s.stream + " (of line 1):1: ", "0 accepted");
}

TEST_CASE("answers of mdm batch are not compared with a stream of answers", "[checker]") {
  const Streamed s(line + "\n", {{1, 1, sample, certificate}});
  const Outcome outcome = s.check({"--answers", s.folder.write("answers.jsonl", "{}\n")});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.rfind(s.stream + ": its certificates are of the answers of another solver", 0) == 0);
}

} // namespace answer_stream_test
