// mdm-check --suite with a stream of certificates: what its index names is checked, nothing else is believed.

#include "catch.hpp"
#include "program.hpp"

namespace proof_stream_test {

using namespace mdm_check_test;

namespace {

const std::string line = R"({"id": "a", "sizes": [1, 2, 3], "masses": [2, 1, 0]})";
const std::string other_line = R"({"id": "b", "sizes": [1, 2, 3], "masses": [2, 9, 0]})";

const std::string &proof() {
  static const std::string text =
      read_file(std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted/sphere_two_classes.proof");
  return text;
}

std::string entry(std::uint64_t number, std::size_t offset, std::size_t length) {
  return std::to_string(number) + " " + std::to_string(offset) + " " + std::to_string(length) + "\n";
}

/// A suite with a stream of certificates and its index.
struct Streamed {
  TemporaryFolder folder;
  std::string suite, stream;

  Streamed(const std::string &lines, const std::string &certificates, const std::string &entries)
      : suite(folder.write("suite.jsonl", lines)), stream(folder.write("all.proofs", certificates)) {
    folder.write("all.proofs.index", "mdm-proofs 1\n" + entries);
  }
  Outcome check(const std::vector<std::string> &more = {}) const {
    std::vector<std::string> arguments = {"--suite", suite, stream};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// The last line.
  std::string summary(const std::string &counts) const {
    return suite + ": " + counts + "; " + counts.substr(0, counts.find(' ')) +
           " accepted as the smallest number of particles that matches exactly (mass law x^3)\n";
  }
};

/// Exit code 2, and the one certificate that counts as malformed has this reason.
void check_broken(const Streamed &s, const std::string &reason) {
  const Outcome outcome = s.check();
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("malformed: " + s.stream + reason) != std::string::npos);
  CHECK(outcome.out.find(" 1 malformed,") != std::string::npos);
  CHECK(outcome.err.empty());
}

/// Two lines with their certificates, and a blank line between them.
Streamed two(const std::string &entries) {
  return Streamed(line + "\n\n" + line + "\n", proof() + proof(), entries);
}

} // namespace

TEST_CASE("the certificates of a stream are checked against the lines of its index", "[checker]") {
  const std::size_t length = proof().size();
  const Streamed s = two(entry(1, 0, length) + entry(3, length, length));
  const Outcome outcome = s.check({"-j", "3", "--verbose"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find(s.suite + ":1\" exactly (") != std::string::npos);
  CHECK(outcome.out.find(s.suite + ":3\" exactly (") != std::string::npos);
  CHECK(outcome.out.ends_with(s.summary("2 accepted, 0 refused, 0 malformed, 0 missing")));
  CHECK(s.check().out == s.summary("2 accepted, 0 refused, 0 malformed, 0 missing"));
}

TEST_CASE("a line that the index of a stream does not name is missing", "[checker]") {
  const Streamed s(line + "\n" + line + "\n" + line, proof(), entry(2, 0, proof().size()));
  const Outcome outcome = s.check();
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out == "missing: " + s.suite + ":1: no certificate in the stream\nmissing: " + s.suite +
                           ":3: no certificate in the stream\n" +
                           s.summary("1 accepted, 0 refused, 0 malformed, 2 missing"));
}

TEST_CASE("one wrong certificate of a stream leaves the others as they are", "[checker]") {
  const std::size_t length = proof().size();
  std::string changed = proof();
  changed[changed.find("scale")] = 'S';
  const Streamed s(line + "\n" + line + "\n" + other_line + "\n" + line + "\n",
                   proof() + changed + proof() + proof(),
                   entry(1, 0, length) + entry(2, length, length) + entry(3, 2 * length, length) +
                       entry(4, 3 * length, length));
  const Outcome outcome = s.check();
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("malformed: " + s.stream + " (of line 2):") == 0);
  CHECK(outcome.out.find("refused: " + s.stream + " (of line 3):") != std::string::npos);
  CHECK(outcome.out.ends_with(s.summary("2 accepted, 1 refused, 1 malformed, 0 missing")));
}

TEST_CASE("no change of one byte of a stream of proofs changes what it proves", "[checker]") {
  const std::size_t length = proof().size();
  const auto checked = [&](const std::string &stream) {
    const Streamed s(line + "\n" + line + "\n", stream, entry(1, 0, length) + entry(2, length, length));
    const Outcome outcome = s.check({"--verbose"});
    std::string out = outcome.out;
    for (std::size_t at = out.find(s.suite); at != std::string::npos; at = out.find(s.suite))
      out.erase(at, s.suite.size());
    return std::pair(outcome.exit_code, out);
  };
  const auto unchanged = checked(proof() + proof());
  CHECK(unchanged.first == 0);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < 2 * length; i += 5) {
    std::string stream = proof() + proof();
    stream[i] ^= 1;
    const auto outcome = checked(stream);
    if (outcome.first != 0)
      ++seen;
    else // a wider enclosure of a size, say
      CHECK(outcome == unchanged);
  }
  CHECK(seen > 2 * length / 5 - 10);
}

TEST_CASE("an index that lies is malformed", "[checker]") {
  const std::size_t length = proof().size();
  const std::string first = entry(1, 0, length);
  check_broken(two(first + entry(3, length + 1, length)), ".index:3: offset ");
  check_broken(two(entry(1, 1, length)), ".index:2: offset 1, where the certificate before ends at 0");
  check_broken(two(first + entry(3, length, length + 1)), " (of line 3): the stream ends before its ");
  check_broken(two(first), ": goes on behind the ");
  check_broken(two(first + entry(1, length, length)), ".index:3: line 1 does not ascend");
  check_broken(two(first + entry(2, length, length)), ".index:3: line 2 is blank");
  check_broken(two(first + entry(4, length, length)), ".index:3: no line 4 in ");
  check_broken(two(first + entry(3, length, 0)), ".index:3: a certificate has 1 byte to 256 MiB");
  check_broken(two(first + entry(3, length, std::size_t{1} << 40U)), ".index:3: a certificate has 1 byte");
  check_broken(two("0 0 0\n"), ".index:2: ");
  for (const char *wrong : {"1 0", "1 0 ", "01 0 5\n", "1  0 5\n", "-1 0 5\n", "1 0 5 6\n", "\n", "1 0 x\n",
                            "1 0 1000000000000000000\n", "\xFF\n", "1 0 248"})
    check_broken(two(wrong), ".index:2: no three numbers");
}

TEST_CASE("a wrong length gives no certificate a part of its neighbour", "[checker]") {
  const std::size_t length = proof().size();
  const Outcome outcome = two(entry(1, 0, length - 1) + entry(3, length - 1, length + 1)).check();
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.find("0 accepted, 0 refused, 2 malformed") != std::string::npos);
}

TEST_CASE("an index that is none, and a stream that is cut short, are malformed", "[checker]") {
  const std::size_t length = proof().size();
  for (const char *none : {"", "mdm-proofs 2\n", "1 0 248\n", "mdm-proofs 1"}) {
    const Streamed s = two("");
    s.folder.write("all.proofs.index", none);
    check_broken(s, ".index:");
  }
  const std::string entries = entry(1, 0, length) + entry(3, length, length);
  check_broken(Streamed(line + "\n\n" + line, proof() + proof().substr(0, 100), entries),
               " (of line 3): the stream ends before its ");
  check_broken(Streamed(line + "\n\n" + line, proof(), entries), " (of line 3): the stream ends before its ");
}

TEST_CASE("a stream without its suite or its index is refused", "[checker]") {
  const Streamed s = two("");
  const Outcome alone = run({"--suite", s.stream});
  CHECK(alone.exit_code == 2);
  CHECK(alone.err.find("a suite and their stream") != std::string::npos);
  std::filesystem::remove(s.stream + ".index");
  const Outcome unnamed = s.check();
  CHECK(unnamed.exit_code == 2);
  CHECK(unnamed.out.empty());
  CHECK(unnamed.err.find(s.stream + ".index: cannot be read: ") == 0);
}

} // namespace proof_stream_test
