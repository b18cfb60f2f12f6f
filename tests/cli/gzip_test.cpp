// Files whose names end in .gz: what gzip wrote mdm reads, whole or not at all.

#include "run.hpp"
#include "tools.hpp"

using namespace cli_test;

namespace {

const std::string sand = "size_mm,mass\n1,8\n2,64\n4,0\n";

/// The file, packed.
std::string packed(const TemporaryFolder &folder, const std::string &name, const std::string &content) {
  const std::string file = folder.write(name, content);
  const Outcome done = Process("/bin/sh", {"-c", "gzip -nf '" + file + "'"}).end();
  INFO(done.err);
  REQUIRE(done.exit_code == 0);
  return file + ".gz";
}

} // namespace

TEST_CASE("gradations, suites and particles that gzip packed are read", "[gzip]") {
  const TemporaryFolder folder;
  const std::string plain = folder.write("g.csv", sand);
  const std::string gradation = packed(folder, "p.csv", sand);
  CHECK(mdm({"convert", gradation}).out == mdm({"convert", plain}).out);
  const std::string suite = R"({"id":"a","sizes":["1","2","3"],"masses":["2","1","0"]})"
                            "\n";
  CHECK(mdm({"batch", packed(folder, "s.jsonl", suite)}).out == mdm({"batch", "-"}, suite).out);
  std::string dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n40000\nITEM: ATOMS id diameter\n";
  for (int i = 0; i < 40000; ++i)
    dump += std::to_string(i) + (i % 2 == 0 ? " 0.002\n" : " 0.004\n");
  const Outcome verified = mdm({"verify", plain, packed(folder, "run.dump", dump)});
  CHECK(verified.exit_code == 0);
  CHECK(contains(verified.out, "matches exactly"));
}

TEST_CASE("several members of gzip are one text", "[gzip]") {
  const TemporaryFolder folder;
  const std::string begin = packed(folder, "a", "size_mm,mass\n1,8\n"),
                    end = packed(folder, "b", "2,64\n4,0\n");
  const std::string both = folder.write("both.csv.gz", read_file(begin) + read_file(end));
  CHECK(mdm({"convert", both}).out == mdm({"convert", folder.write("g.csv", sand)}).out);
}

TEST_CASE("a file of gzip that is cut off or damaged is refused", "[gzip]") {
  const TemporaryFolder folder;
  const std::string whole = read_file(packed(folder, "g.csv", sand));
  for (std::size_t length = 1; length < whole.size(); ++length)
    check_refused(mdm({"convert", folder.write("cut.csv.gz", whole.substr(0, length))}), "cut.csv.gz");
  std::string damaged = whole;
  damaged[damaged.size() - 6] ^= 1; // of the checksum
  check_refused(mdm({"convert", folder.write("d.csv.gz", damaged)}), "cannot be unpacked");
  check_refused(mdm({"convert", folder.write("t.csv.gz", whole + "more")}), "cannot be unpacked");
  check_refused(mdm({"convert", folder.write("no.csv.gz", sand)}), "cannot be unpacked");
  check_refused(mdm({"verify", folder.write("g.csv", sand), folder.write("run.dump", whole)}),
                "let its name end in .gz");
}
