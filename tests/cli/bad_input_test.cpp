// Gradation files that are none: exit 2, a message that names file and line, no output.

#include "run.hpp"

namespace bad_input_test {

using namespace cli_test;

namespace {

/// The text is refused by solve and convert, at the line (0: none is known).
void check_bad(const std::string &text, int line, const std::string &name = "bad.csv") {
  INFO(text.substr(0, 200));
  const TemporaryFolder folder;
  const std::string path = folder.write(name, text);
  const std::string where = path + ":" + (line > 0 ? std::to_string(line) + ": " : "");
  check_refused(mdm({"solve", path, "-o", folder / "answer", "--proof", folder / "proof"}), where);
  check_refused(mdm({"convert", path, "-o", folder / "answer"}), where);
  check_refused(mdm({"solve", "-"}, text), line > 0 ? ":" + std::to_string(line) + ": " : "");
  CHECK(folder.entries() == 1);
}

} // namespace

TEST_CASE("masses that are no numbers", "[cli]") {
  for (const char *mass : {"much",
                           "",
                           "NaN",
                           "nan",
                           "inf",
                           "-inf",
                           "Infinity",
                           "1e999999999",
                           "1e-999999999",
                           "1e401",
                           "-1",
                           "-0.001",
                           "0x10",
                           "1_000",
                           "1 000",
                           "1e",
                           "1e+",
                           ".",
                           "+",
                           "--1",
                           "1.2.3",
                           "\xE2\x88\x92"
                           "1",
                           "1%"})
    check_bad(std::string("size_mm,mass\n1,2\n2,") + mass + "\n3,0\n", 3);
  check_bad("size_mm,mass\n1," + std::string(1001, '1') + "\n2,0\n", 2);
}

TEST_CASE("sizes that are no numbers", "[cli]") {
  for (const char *size : {"fine", "", "NaN", "inf", "1e999999999", "-1", "pans"})
    check_bad(std::string("size_mm,mass\n") + size + ",1\n2,1\n3,0\n", 2);
  check_bad("sieve,mass\nNo. 201,1\nNo. 4,0\n", 2);
  check_bad("sieve,mass\nNo. 200,1\n200,1\nNo. 4,0\n", 3);
  check_bad("size_phi,mass\n1001,1\n2,0\n", 2);
}

TEST_CASE("ten megabytes of digits", "[cli]") {
  const std::string digits(10'000'000, '7');
  check_bad("size_mm,mass\n1,2\n2," + digits + "\n3,0\n", 3);
  check_bad("size_mm,mass\n" + digits + ",2\n2,1\n3,0\n", 2);
  check_bad("size_mm,mass\n1,1e" + digits + "\n3,0\n", 2);
  check_bad("{\"sizes\":[1,2],\"masses\":[" + digits + ",0]}", 1, "bad.json");
  check_bad("{\"sizes\":[1,2],\"masses\":[\"" + digits + "\",0]}", 1, "bad.json");
}

TEST_CASE("curves that are none", "[cli]") {
  check_bad("size_mm,passing_percent\n1,10\n2,101\n3,100\n", 3);
  check_bad("size_mm,passing_percent\n1,50\n2,40\n3,100\n", 3);
  check_bad("size_mm,passing_fraction\n1,0.5\n2,1.5\n", 3);
  check_bad("size_mm,cumulative_retained_percent\n1,101\n2,0\n", 2);
  check_bad("size_mm,passing_percent\n1,10\n2,90\n", 3);
  check_bad("size_mm,mass\n1,10\n2,1\n", 3);
  check_bad("size_mm,mass\n1,0\n2,0\n", 1);
  check_bad("size_mm,mass\n1,1\n2,1\n1.0,1\n3,0\n", 4);
  check_bad("sieve,mass\nNo. 4,1\n4.75 mm,1\n1 in,0\n", 3);
  check_bad("size_mm,mass,factor\n1,1,0\n2,0,1\n", 2);
}

TEST_CASE("files without rows", "[cli]") {
  check_bad("", 1);
  check_bad("\n \n", 0);
  check_bad("# nothing\n", 0);
  check_bad("size_mm,mass\n", 1);
  check_bad("size_mm,mass\n1,0\n", 1);
}

TEST_CASE("headers and rows that do not fit", "[cli]") {
  check_bad("d50,mass\n1,1\n2,0\n", 1);
  check_bad("size_mm,weight\n1,1\n2,0\n", 1);
  check_bad("size_mm,mass,colour\n1,1,red\n2,0,red\n", 1);
  check_bad("size_mm\n1\n2\n", 1);
  check_bad("1,1\n2,0\n", 1);
  check_bad("size_mm,mass\n1,1,1\n2,0\n", 2);
  check_bad("size_mm,mass\n1\n2,0\n", 2);
  check_bad("size_mm;mass\n1,5;2\n2.5;1\n3;0\n", 3);
  check_bad("size_mm,mass\n\"1,1\n2,0\n", 2);
}

TEST_CASE("bytes that are no text", "[cli]") {
  check_bad(std::string("\x7F"
                        "ELF\x02\x01\x01\0\0\0",
                        10),
            1);
  check_bad(std::string("size_mm,mass\n1,2\n2,1\n3,0\n\0", 26), 5);
  check_bad("size_mm,mass\n1,2\n2,\xFF\n3,0\n", 3);
  std::string bytes;
  for (int i = 0; i < 1 << 16; ++i)
    bytes += static_cast<char>(i * 7919 >> 3);
  check_bad(bytes, 0);
  const TemporaryFolder folder;
  check_refused(mdm({"solve", MDM_PROGRAM, "-o", folder / "answer"}), MDM_PROGRAM);
  CHECK(folder.entries() == 0);
}

TEST_CASE("JSON that is no gradation", "[cli]") {
  for (const char *text : {"{",
                           "{}",
                           "{\"sizes\":[1,2]}",
                           "{\"sizes\":[1,2],\"masses\":[1]}",
                           "{\"sizes\":[1],\"masses\":[0]}",
                           "{\"sizes\":[1,2],\"masses\":[1e400,0]}",
                           "{\"sizes\":[1,2],\"masses\":[NaN,0]}",
                           "{\"sizes\":[1,2],\"masses\":[null,0]}",
                           "{\"sizes\":[1,2],\"masses\":[true,0]}",
                           "{\"sizes\":[1,2],\"masses\":[\"x\",0]}",
                           "{\"sizes\":[1,2],\"masses\":[-1,0]}",
                           "{\"sizes\":[1,2],\"masses\":[1,1]}",
                           "{\"sizes\":[1,1],\"masses\":[1,0]}",
                           "{\"sizes\":[1,3,2],\"masses\":[1,0,0]}",
                           "{\"sizes\":[1,2],\"masses\":[1,0],\"sizes\":[1,2]}",
                           "{\"sizes\":[1,2],\"masses\":[1,0],\"unit\":\"furlong\"}",
                           "{\"sizes\":[1,2],\"masses\":[1,0]} x",
                           "{\"sizes\":[1,2],\"masses\":[1,0],\"id\":[]}",
                           "{\"sizes\":{},\"masses\":[1,0]}",
                           "{\"sizes\":[[1],2],\"masses\":[1,0]}"})
    check_bad(text, 1, "bad.json");
  check_bad("{\"sizes\":[1,2],\n\"masses\":[1e400,0]}", 2, "bad.json");
}

TEST_CASE("JSON without a bottom", "[cli]") {
  check_bad("{\"x\":" + std::string(5'000'000, '['), 1, "bad.json");
  std::string objects;
  for (int i = 0; i < 1'000'000; ++i)
    objects += "{\"x\":";
  check_bad(objects, 1, "bad.json");
}

TEST_CASE("files that cannot be read", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string &path : {folder / "missing.csv", folder / ".", std::string("/dev/zero")}) {
    check_refused(mdm({"solve", path, "-o", folder / "answer"}), path);
    check_refused(mdm({"convert", path, "-o", folder / "answer"}), path);
  }
  check_refused(mdm({"batch", folder / "missing.jsonl", "-o", folder / "answers"}), "missing.jsonl");
  check_refused(mdm({"batch", folder / ".", "-o", folder / "answers"}));
  CHECK(folder.entries() == 0);
}

TEST_CASE("messages quote input escaped and cut", "[cli]") {
  const TemporaryFolder folder;
  const auto message = [&](const std::string &mass) {
    return mdm({"solve", folder.write("bad.csv", "size_mm,mass\n1," + mass + "\n2,0\n")}).err;
  };
  CHECK(message("a\tb").find("a\\x09b") != std::string::npos);
  CHECK(message("\xC3\xA9").find("\xC3\xA9") != std::string::npos);
  CHECK(message(std::string(500, 'x')).size() < 500);
}

TEST_CASE("messages name the file and say what to do", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", "size_mm,mass\n1,2\n2,1\n3,0\n");
  const auto refused = [&](Arguments arguments, const std::string &part) {
    arguments.insert(arguments.begin(), "solve");
    check_refused(mdm(arguments), part);
  };
  refused({sand, "--time-limit", "-1"}, "--time-limit: '-1' is negative: write a number from 0 on");
  refused({sand, "--cut-below", "3"}, sand + ": cutting at the largest sieve, 3 mm, leaves nothing: cut at");
  refused({sand, "--pan-size", "0.5"}, "the finest sieve has 1 mm: leave the pan's size out");
  refused({folder / "none.csv"}, "cannot be read: No such file or directory: name one that can be read");
  refused({sand, "-o", folder / "none/a"},
          "cannot be written: No such file or directory: write it elsewhere");
  const std::string inches =
      folder.write("inches.csv", "size_in,mass\n0." + std::string(999, '7') + ",1\n2,0\n");
  check_refused(mdm({"convert", inches}), inches + ": a number of this gradation has no decimal of at most");
}

TEST_CASE("a carriage return without a line feed hides no particle", "[cli]") {
  const TemporaryFolder folder;
  const std::string small = R"({"id":"small","sizes":[1,2,3],"masses":[2,1,0]})";
  const std::string gradation = folder.write("g.json", small);
  const std::string message = "a carriage return (CR) is there that no line feed (LF) follows";
  check_refused(mdm({"verify", gradation, "-"}, "size_mm,quantity\n# lab 7\r1.5,40\n2,1\n"),
                ":2: " + message);
  const std::string answers = folder.write("a.csv", "id,quantities\n# x\rsmall,6 2\nsmall,3 1\n");
  check_refused(mdm({"crosscheck", "-", answers}, small), ":2: " + message);
}

} // namespace bad_input_test
