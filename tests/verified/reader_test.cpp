// What the reader that is extracted from Coq makes of a gradation file: its canonical CSV, or a message.

#include "catch.hpp"
#include "checker/mutants.hpp"

#include <cstdlib>

namespace reader_test {

namespace {

struct Outcome {
  int exit_code;
  std::string output, errors;
};

class Folder {
public:
  std::string write(const std::string &name, const std::string &text) const {
    mdm_check_test::write_file(path(name), text);
    return path(name);
  }
  Outcome run(const std::string &arguments) const {
    const std::string command =
        "cd '" + folder_.path().string() + "' && '" MDM_VERIFIED "' " + arguments + " >output 2>errors";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), mdm_check_test::read_file(path("output")),
            mdm_check_test::read_file(path("errors"))};
  }
  /// The gradation file as it is read, or the message.
  std::string printed(const std::string &name, const std::string &text) const {
    write(name, text);
    const Outcome outcome = run("--print " + name);
    CHECK(outcome.exit_code == (outcome.errors.empty() ? 0 : 2));
    return outcome.output + outcome.errors;
  }

private:
  std::string path(const std::string &name) const { return (folder_.path() / name).string(); }
  mdm_check_test::TemporaryFolder folder_;
};

bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a gradation is printed as canonical CSV") {
  const Folder folder;
  CHECK(folder.printed("a.csv", "size_in;retained_percent\n2;0,50\n\n# comment\n1;1e1\n3;0\n") ==
        "size_mm,mass\n25.4,10\n50.8,0.5\n76.2,0\n");
  CHECK(folder.printed("a.csv", "sieve,passing_percent\n\"#200\",4.1\n3/8 in,100\n") ==
        "size_mm,mass\n0,4.1\n0.075,95.9\n9.5,0\n");
  CHECK(folder.printed("a.csv", "size_um,mass,factor,tolerance_percent\n20,0,1,0\n10,5,0.5,2.50\n") ==
        "size_um,mass,tolerance_percent,factor\n10,5,2.5,0.5\n20,0,0,1\n");
  CHECK(folder.printed("a.csv", "size_phi,mass\n-1.50,0\n0.25,3\nPan,1\n") ==
        "size_phi,mass\npan,1\n0.25,3\n-1.5,0\n");
  CHECK(folder.printed("a.json", R"({"unit": "m", "sizes": [3e-3, "2e-3", 1E-3], "masses": [0, 1, 2]})") ==
        "size_m,mass\n0.001,2\n0.002,1\n0.003,0\n");
  CHECK(folder.printed("a.csv", "size_mm,passing_min_percent,passing_max_percent\n2,100,100\n1,5,10\n") ==
        "size_mm,passing_min_percent,passing_max_percent\n1,5,10\n2,100,100\n");
}

TEST_CASE("a number behind # is neither a comment nor a sieve") {
  const Folder folder;
  const std::string remedy = "may be a sieve or a comment: write No. 4 for a sieve";
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n#4,50\n1,2\n2,0\n"), "a.csv:2: a number behind #"));
  CHECK(contains(folder.printed("a.csv", "#4\nsize_mm,mass\n1,2\n2,0\n"), remedy));
  CHECK(contains(folder.printed("a.csv", "sieve,mass\n# 12,1\nNo. 8,1\nNo. 4,0\n"), remedy));
  CHECK(folder.printed("a.csv", "# 4\nsize_mm,mass\n# 4,50\n#x\n#\n1,2\n2,0\n") ==
        "size_mm,mass\n1,2\n2,0\n");
}

TEST_CASE("a character that turns lines or their direction is refused") {
  const Folder folder;
  for (const char *mark :
       {"\u2028", "\u2029", "\u061C", "\u200E", "\u200F", "\u202A", "\u202E", "\u2066", "\u2069"})
    CHECK(contains(folder.printed("a.csv", "size_mm,mass\n# note" + std::string(mark) + "1,500\n1,2\n2,0\n"),
                   "a.csv:2: a line separator or a mark of the direction of writing"));
  CHECK(contains(folder.printed("a.csv", "# note\u00851,500\nsize_mm,mass\n1,2\n2,0\n"),
                 "a.csv:1: a control character"));
  CHECK(folder.printed("a.csv", "# \u2027 \u202F \u2065 \u061B\nsize_mm,mass\n1,2\n2,0\n") ==
        "size_mm,mass\n1,2\n2,0\n");
}

TEST_CASE("what is printed is read as the same") {
  const Folder folder;
  for (const char *text :
       {"size_m,passing_fraction\n0.1,0.25\n0.3,1\n", "size_phi,mass\n-0.3,0\n0.7,3\n2,1\n",
        "size_mm,cumulative_retained_percent,tolerance_percent\n1,80,1\n2,0,2\n",
        "size_um,passing_min_percent,passing_max_percent\n0,0,3\n7,100,100\n"}) {
    const std::string once = folder.printed("a.csv", text);
    CHECK(folder.printed("b.csv", once) == once);
  }
}

TEST_CASE("a carriage return that no line feed follows hides no row") {
  const Folder folder;
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n# lab 7\r1,40\n1,2\n2,1\n3,0\n"),
                 "a.csv:2: a carriage"));
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n1,2\n\"2\r\",1\n3,0\n"), "a.csv:3: a carriage"));
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n1,2\n2,1\n3,0\r"), "a.csv:4: a carriage"));
  CHECK(contains(folder.printed("a.json", "{\"sizes\":\r[1,2],\"masses\":[1,0]}"), "a.json:1: a carriage"));
  CHECK(folder.printed("a.csv", "size_mm,mass\r\n1,2\r\n3,0\r\n") == "size_mm,mass\n1,2\n3,0\n");
}

TEST_CASE("what stands in quotes is taken as it is") {
  const Folder folder;
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n\"pan \",2\n2,1\n3,0\n"),
                 "a.csv:2: 'pan ' is not a number"));
  CHECK(contains(folder.printed("a.csv", "size_mm,mass\n1,\" 1\"\n3,0\n"), "a.csv:2: ' 1' is not a number"));
  CHECK(folder.printed("a.csv", "sieve,mass\n\" # 200 \",1\n\"1/4 in.\",0\n") ==
        "size_mm,mass\n0.075,1\n6.3,0\n");
}

TEST_CASE("no key of JSON is skipped") {
  const Folder folder;
  const std::string rest = "\"sizes\": [1, 2],\n\"masses\": [1, 0]}";
  CHECK(folder.printed("a.json", "{" + rest) == "size_mm,mass\n1,1\n2,0\n");
  CHECK(contains(folder.printed("a.json", "{\n\"factor\": [1, 1], " + rest),
                 "a.json:2: an unknown key 'factor'"));
  CHECK(
      contains(folder.printed("a.json", "{\"units\": \"um\", " + rest), "a.json:1: an unknown key 'units'"));
  CHECK(contains(folder.printed("a.json", "{\"id\": 1e309, " + rest), "a.json:1: beyond the range"));
  CHECK(contains(folder.printed("a.json", "{\"id\": 1e401, " + rest), "exponent beyond 400"));
  CHECK(contains(folder.printed("a.json", "{\"id\": null, " + rest), "no value of JSON"));
  CHECK(contains(folder.printed("a.json", "{" + rest + "x"), "something follows"));
}

TEST_CASE("phi is exact up to a common denominator of 1000") {
  const Folder folder;
  CHECK(folder.printed("a.csv", "size_phi,mass\n-0.001,0\n0.5,1\n") == "size_phi,mass\n0.5,1\n-0.001,0\n");
  CHECK(contains(folder.printed("a.csv", "size_phi,mass\n-0.0001,0\n0.5,1\n"), "mdm convert"));
  CHECK(contains(folder.printed("a.csv", "size_phi,mass\n0.016,0\n0.1,1\n0.2,1\n1000.5,1\n"),
                 "a phi beyond 1000"));
  CHECK(contains(folder.printed("a.csv", "size_phi,passing_min_percent,passing_max_percent\n0.5,100,100\n"),
                 "give the openings of a band in mm"));
}

TEST_CASE("an envelope is judged by its own limits") {
  const Folder folder;
  folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n1,100,100\n");
  folder.write("sand.csv", "size_mm,mass\n0,1\n1,0\n");
  const auto proof = [](const std::string &lines) {
    return "mdm-certificate 1\nlaw 1\n" + lines + "particles 1\nclass 1 1 1 1 1\nleaf 1 N 1 n\nend\n";
  };
  folder.write("file.proof", proof("band file\n"));
  folder.write("lines.proof", proof("band 1 100 100\n"));
  folder.write("both.proof", proof("band file\nband 2 100 100\n"));
  const Outcome accepted = folder.run("limits.csv file.proof");
  CHECK(accepted.output == "accepted: N = 1 is the smallest number of particles that matches \"limits.csv\" "
                           "within a tolerance (passing "
                           "within the file's limits; mass law x^1; sizes in mm; a pan implied below the "
                           "finest sieve; masses from the "
                           "middle of the file's limits)\n");
  CHECK(folder.run("sand.csv lines.proof").exit_code == 0);
  CHECK(folder.run("limits.csv lines.proof").exit_code == 1);
  CHECK(folder.run("sand.csv file.proof").exit_code == 1);
  CHECK(folder.run("limits.csv both.proof").exit_code == 2);
}

TEST_CASE("a row that is longer than any can be is malformed at once, and a comment may be") {
  const Folder folder;
  const std::string digits(1000000, '9');
  for (const std::string &text : {"size_mm,mass\n1," + digits + "\n2,0\n", digits + "\n1,1\n2,0\n"}) {
    folder.write("long.csv", text);
    const Outcome outcome = folder.run("--print long.csv");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output.empty());
    CHECK(contains(outcome.errors, "a line is longer than 16384 characters"));
  }
  folder.write("comment.csv", "# " + digits + "\nsize_mm,mass\n1,1\n2,0\n");
  CHECK(folder.run("--print comment.csv").output == "size_mm,mass\n1,1\n2,0\n");
}

TEST_CASE("the verdict's line quotes the file's name, and a refusal gives its reason apart") {
  const Folder folder;
  const std::string name = "x exactly (law); \"a\\b\xC2\xAD\xD8\x9C\xE2\x80\x8B\x01\xFF\xC3\xA4";
  folder.write(name, "size_mm,mass\n1,2\n2,1\n3,0\n");
  folder.write(
      "proof",
      "mdm-certificate 1\nlaw 3\nparticles 3\nscale 8\nclass 1 2 2 2\nclass 2 1 2 2\nchain 2\nend\n");
  const Outcome refused = folder.run("x* proof");
  CHECK(refused.exit_code == 1);
  CHECK(refused.output ==
        "refused: the certificate does not prove its claim about \"x exactly (law); \\\"a\\\\b\\xC2"
        "\\xAD\\xD8\\x9C\\xE2\\x80\\x8B\\x01\\xFF\xC3\xA4\"\n");
  CHECK(contains(refused.errors, "proof: "));
  CHECK(folder.run("--print x* proof").output == "size_mm,mass\n1,2\n2,1\n3,0\n" + refused.output);
  folder.write("malformed", "mdm-certificate 2\n");
  const Outcome malformed = folder.run("--print x* malformed");
  CHECK(malformed.exit_code == 2);
  CHECK(malformed.output.empty());
}

} // namespace reader_test
