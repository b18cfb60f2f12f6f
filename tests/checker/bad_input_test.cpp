// What cannot be read, or written, is exit 2 with a message and nothing on standard output.

#include "catch.hpp"
#include "program.hpp"
#include "sanitizers.hpp"

#include <algorithm>
#include <ctime>
#include <sstream>

namespace bad_input_test {

using namespace mdm_check_test;

namespace {

const char *const good_gradation = "size_mm,mass\n1,2\n2,1\n3,0\n";

std::string accepted(const std::string &file) {
  return (std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted" / file).string();
}

void check_exit_2(const Outcome &outcome, const std::string &beginning) {
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.rfind(beginning, 0) == 0);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(outcome.err.size() < beginning.size() + 400);
  CHECK(std::all_of(outcome.err.begin(), outcome.err.end(),
                    [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= ' '; }));
}

/// A gradation that is wrong in the given line.
void check_gradation(const std::string &text, int line) {
  const TemporaryFolder folder;
  const std::string path = write_file(folder.path() / "bad.csv", text).string();
  INFO(text.substr(0, 200));
  check_exit_2(run({path, accepted("sphere_two_classes.proof")}), path + ":" + std::to_string(line) + ": ");
}

std::string with_mass(const std::string &mass) {
  return "size_mm,mass\n1,2\n2," + mass + "\n3,0\n";
}

} // namespace

TEST_CASE("numbers that are none, or out of bounds", "[checker]") {
  for (const char *mass : {"much", "nan", "inf", "-inf", "1e999999999", "1e-999999999", "-1", "0x10", "1,",
                           "", ".", "1e", "1 2", "1_0",
                           "\xE2\x88\x92"
                           "1",
                           "1e+", "--1", "1.2.3"})
    check_gradation(with_mass(mass), 3);
  check_gradation(with_mass(std::string(10'000'000, '7')), 3);
  check_gradation(with_mass("1e" + std::string(10'000'000, '7')), 3);
}

TEST_CASE("gradations that are none", "[checker]") {
  check_gradation("", 1);
  check_gradation("\n \t\n", 1);
  check_gradation("size_mm,mass\n1,0\n", 1);
  check_gradation("diameter,mass\n1,2\n2,1\n3,0\n", 1);
  check_gradation("size_mm,weight\n1,2\n2,1\n3,0\n", 1);
  check_gradation("size_mm,passing_percent\n1,10\n2,101\n3,100\n", 3);
  check_gradation("size_mm,passing_percent\n1,50\n2,40\n3,100\n", 2);
  check_gradation("size_mm,mass\n1,2\n2,1\n1.0,1\n3,0\n", 4);
  check_gradation("size_mm,mass\n1,2\n2,1\n", 3);
  check_gradation("sieve,mass\nNo. 201,2\nNo. 100,1\nNo. 4,0\n", 2);
  check_gradation("size_mm;mass\n1,5;2\n2.5;1\n3;0\n", 3);
  check_gradation("{\"sizes\": [1, 2, 3], \"masses\": [2, 1e400, 0]}", 1);
  check_gradation("{\"sizes\": [1, 2, 3],\n\"masses\": " + std::string(1'000'000, '['), 2);
  check_gradation("{\"sizes\": [1, 2, 3],\n\"units\": \"in\"}", 2);
  check_gradation("# lab 7\r1,40\nsize_mm,mass\n1,2\n2,1\n3,0\n", 1);
  check_gradation("size_mm,mass\n1,2\n2,1\n\"pan \",1\n3,0\n", 4);
  check_gradation("size_phi,mass\n0.001,1\n0.0001,1\n0,0\n", 3);
}

TEST_CASE("binary files and text that is not UTF-8", "[checker]") {
  check_gradation(std::string("\x7F"
                              "ELF\x02\x01\x01\0\0\0",
                              10),
                  1);
  check_gradation(std::string("size_mm,mass\n1,2\n2,1\n3,0\n\0", 26), 5);
  for (const char *bytes :
       {"\xFF", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80", "\x1B[31m", "\xC2\x85"})
    check_gradation(std::string("# \n") + bytes + "\n" + good_gradation, 2);
  std::string bytes;
  for (int i = 0; i < 1 << 16; ++i)
    bytes += static_cast<char>(i * 7919 >> 3);
  check_gradation(bytes, 1);
}

TEST_CASE("messages quote input escaped and cut", "[checker]") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string &mass) {
    const std::string path = write_file(folder.path() / "bad.csv", with_mass(mass)).string();
    return run({path, accepted("sphere_two_classes.proof")}).err.substr(path.size());
  };
  CHECK(message("a\tb") == ":3: 'a\\x09b' is not a number: write a decimal such as 0.075\n");
  CHECK(message("\xE2\x80\x8B"
                "1") == ":3: '\\xE2\\x80\\x8B1' is not a number: write a decimal such as 0.075\n");
  CHECK(message("\xC3\xA9") == ":3: '\xC3\xA9' is not a number: write a decimal such as 0.075\n");
  CHECK(message(std::string(500, 'x')) ==
        ":3: '" + std::string(80, 'x') + "...' is not a number: write a decimal such as 0.075\n");
}

TEST_CASE("files that cannot be read", "[checker]") {
  const TemporaryFolder folder;
  const std::string proof = accepted("sphere_two_classes.proof");
  const std::string gradation = accepted("sphere_two_classes.csv");
  const std::string missing = (folder.path() / "missing").string();
  check_exit_2(run({missing, proof}), missing + ": ");
  check_exit_2(run({gradation, missing}), missing + ": ");
  check_exit_2(run({folder.path().string(), proof}), folder.path().string() + ": ");
  check_exit_2(run({gradation, folder.path().string()}), folder.path().string() + ": ");
  check_exit_2(run({"/dev/zero", proof}), "/dev/zero: ");
  check_exit_2(run({gradation, "/dev/zero"}), "/dev/zero: ");
  check_exit_2(run({"/dev/null", proof}), "/dev/null:1: ");
  check_exit_2(run({gradation, "/dev/null"}), "/dev/null:1: ");
  check_exit_2(run({"-", proof}, "/dev/zero"), "standard input: ");
  check_exit_2(run({"-", proof}, folder.path().string()), "standard input: ");
  CHECK(run({"-", proof}, gradation).exit_code == 0);
  CHECK(run({gradation, "-"}, proof).exit_code == 0);
}

TEST_CASE("commands that are wrong", "[checker]") {
  const std::string proof = accepted("sphere_two_classes.proof");
  check_exit_2(run({}), "mdm-check: ");
  check_exit_2(run({proof}), "mdm-check: ");
  check_exit_2(run({proof, proof, proof}), proof); // the first is no specification of a blend
  check_exit_2(run({"-", "-"}), "mdm-check: standard input has one file");
  check_exit_2(run({"--verbose", proof}),
               "mdm-check: no option '--verbose' here: there are --print, --suite, --help");
  check_exit_2(run({"", ""}), ": ");
  check_exit_2(run({"--print"}), "mdm-check: ");
  check_exit_2(run({"--print", proof, proof, proof}), "mdm-check: ");
  check_exit_2(run({proof, "--print"}), "mdm-check: ");
}

TEST_CASE("help and version", "[checker]") {
  const Outcome help = run({"--help"});
  std::istringstream lines(help.out);
  for (std::string line; std::getline(lines, line);)
    CHECK(line.size() <= 100);
  CHECK(help.exit_code == 0);
  CHECK(help.out.find("Examples:") != std::string::npos);
  const Outcome version = run({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.out.find("GMP") != std::string::npos);
}

TEST_CASE("output that cannot be written", "[checker]") {
  for (const char *kind : {"sphere_two_classes", "another_law"}) {
    const std::string folder =
        std::string(MDM_CERTIFICATES_DIR) + (kind[0] == 's' ? "/accepted/" : "/rejected/");
    const std::vector<std::string> arguments{folder + kind + ".csv", folder + kind + ".proof"};
    for (const std::vector<std::string> &words : {arguments, {"--help"}, {"--version"}}) {
      check_exit_2(run(words, "/dev/null", "/dev/full"), "standard output: ");
      const Outcome closed = run(words, "/dev/null", "closed pipe"); // the reader has what it wanted
      CHECK(closed.exit_code == 2);
      CHECK(closed.err.empty());
    }
  }
}

TEST_CASE("certificates of numbers without measure end soon", "[checker]") {
  const TemporaryFolder folder;
  const auto exit_code = [&](const std::string &gradation, const std::string &proof) {
    return run({write_file(folder.path() / "g.csv", gradation).string(),
                write_file(folder.path() / "c.proof", proof).string()})
        .exit_code;
  };
  const std::string nines(100'000, '9');
  const std::string sizes = "class 1 1 1.5 1.5\nclass 2 1 2.5 2.5\n";
  CHECK(exit_code(good_gradation, "mdm-certificate 1\nlaw 3\nparticles " + nines + "\nscale " + nines +
                                      "/2\n" + sizes + "chain 1\nend\n") == 1);
  CHECK(exit_code(good_gradation, "mdm-certificate 1\nlaw 3\nat-least 2\nparticles 3\nscale 1\n" + sizes +
                                      "above " + nines + "\nchain 1\nend\n") == 1);
  CHECK(exit_code(good_gradation, "mdm-certificate 1\nlaw 1000\nparticles " + nines + "\nscale 1\n" + sizes +
                                      "chain 1\nend\n") == 2);
  CHECK(exit_code(good_gradation, "mdm-certificate 1\nlaw 3\nsize-factor " + nines +
                                      "\nparticles 2\nscale 1\n" + sizes + "chain 1\nend\n") == 1);
  CHECK(exit_code(good_gradation, "mdm-certificate 1\nlaw 3\ncylinder " + nines + " " + nines + " " + nines +
                                      "\nparticles 2\nscale 1\n" + sizes + "chain 1\nend\n") == 1);
  CHECK(exit_code(
            "size_mm,mass\n1e-400,1e400\n1e-399,1e-400\n1e400,0\n",
            "mdm-certificate 1\nlaw 999/1000\nparticles 2\nscale 1\nclass 1 1 1.5 1.5\nclass 2 1 2.5 2.5\n"
            "chain 1\nend\n") == 2);
  std::string chain = "chain";
  for (int i = 0; i < 2'000'000; ++i)
    chain += " 2";
  CHECK(exit_code(good_gradation,
                  "mdm-certificate 1\nlaw 3\nparticles 2\nscale 1\n" + sizes + chain + "\nend\n") == 1);
  std::string factors = "size_mm,mass,factor\n";
  for (int i = 1; i < 2000; ++i)
    factors += std::to_string(i) + ",1," + std::to_string(i) + std::string(900, '7') + "\n";
  CHECK(exit_code(factors + "9999,0,1\n", "mdm-certificate 1\nlaw 3\ncylinder 1 1 1\nparticles 2\nscale 1\n" +
                                              sizes + "chain 1\nend\n") == 2);
}

TEST_CASE("trees without measure end soon", "[checker]") {
  const TemporaryFolder folder;
  const auto exit_code = [&](const std::string &tree) {
    return run({write_file(folder.path() / "g.csv", good_gradation).string(),
                write_file(folder.path() / "c.proof",
                           "mdm-certificate 1\nlaw 3\nretained 1\nparticles none\n" + tree + "end\n")
                    .string()})
        .exit_code;
  };
  const auto times = [](int n, const std::string &text) {
    std::string all;
    for (int i = 0; i < n; ++i)
      all += text;
    return all;
  };
  CHECK(exit_code(times(1'000'000, "split 1 1\n") + times(1'000'001, "leaf 1 m\n")) == 1);
  CHECK(exit_code(times(3'000'000, "split 1 1\n") + times(3'000'001, "leaf 1 m\n")) == 2);
  std::string conditions;
  for (int i = 1; i <= 300'000; ++i)
    conditions += " 1 f" + std::to_string(i);
  CHECK(exit_code("leaf" + conditions + "\n") == 1);
}

TEST_CASE("many short leaves of many classes end soon", "[checker]") {
  constexpr int classes = 20'000;
  const std::string to_last = "-" + std::to_string(classes);
  std::string gradation = "size_mm,mass\n", singles, sums;
  for (int j = 1; j <= classes; ++j) {
    const std::string name = std::to_string(j), next = std::to_string(j + 1);
    gradation += name + ",1\n";
    if (j < classes)
      singles += "split " + name + " 1\nleaf 1 q" + name + " 1 Q" + name + "\n";
    if (j < classes - 1)
      sums += "split " + name + to_last + " 1\nleaf 1 S" + name + to_last + " 1 q" + name + " 1 s" + next +
              to_last + "\n";
  }
  const TemporaryFolder folder;
  const std::string g = write_file(folder.path() / "g.csv", gradation + "20001,0\n").string();
  const auto exit_code = [&](const std::string &version, const std::string &tree) {
    return run({g, write_file(folder.path() / "c.proof",
                              "mdm-certificate " + version +
                                  "\nlaw 1\nmin-per-class 1\nretained 100\nparticles none\n" + tree +
                                  "leaf 1 m\nend\n")
                       .string()})
        .exit_code;
  };
  const std::clock_t begin = std::clock(); // of this program: others may run beside it
  CHECK(exit_code("1", singles) == 1);     // only the last leaf is wrong
  CHECK(exit_code("2", sums) == 1);
  CHECK((std::clock() - begin) / CLOCKS_PER_SEC < (MDM_IS_SANITIZED ? 80 : 20));
}

TEST_CASE("half-phi of a large root ends soon", "[checker]") {
  const TemporaryFolder folder;
  const auto exit_code = [&](const std::string &gradation, const std::string &line) {
    return run({write_file(folder.path() / "g.csv", gradation).string(),
                write_file(folder.path() / "c.proof",
                           "mdm-certificate 1\nlaw 3\n" + line +
                               "\nparticles 1\nscale 1\nclass 1 1 0.9 0.9\nchain 1\nend\n")
                    .string()})
        .exit_code;
  };
  const std::string nines(100'000, '9'), two = "size_phi,mass\n0.001,1\n0,0\n";
  CHECK(exit_code(two, "cylinder " + nines + " " + nines + " " + nines) == 2);
  CHECK(exit_code(two, "size-factor " + nines) == 2);
  std::string many = "size_phi,mass\n";
  for (int i = 0; i < 20'000; ++i)
    many += std::to_string(900'000 + i) + "e-3,1\n";
  CHECK(exit_code(many + "0,0\n", "size-factor 2") == 2);
}

} // namespace bad_input_test
