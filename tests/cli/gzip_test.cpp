// Files whose names end in .gz: what gzip wrote mdm reads, whole or not at all.

#include "run.hpp"
#include "tools.hpp"

namespace gzip_test {

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
}

TEST_CASE("what is packed is told by its first bytes, whatever its name", "[gzip]") {
  const TemporaryFolder folder;
  const std::string gradation = folder.write("no-ending.csv", read_file(packed(folder, "g.csv", sand)));
  CHECK(mdm({"convert", gradation}).out == mdm({"convert", folder.write("g.csv", sand)}).out);
  check_refused(mdm({"solve", gradation, "--proof", folder / "p.gz"}), "p.gz: mdm writes no .gz");
}

TEST_CASE("the table of a law may be packed", "[gzip]") {
  const TemporaryFolder folder;
  const std::string law = packed(folder, "law.csv", "size_mm,particle_mass\n0,0\n1,1\n2,5\n4,30\n");
  CHECK(mdm({"solve", folder.write("g.csv", sand), "--law", "table:" + law}).exit_code == 0);
}

TEST_CASE("beside a proof of a packed gradation stands one that is not", "[gzip]") {
  const TemporaryFolder folder;
  const std::string gradation = packed(folder, "g.csv", sand), proof = folder / "p";
  const Outcome solved = mdm({"solve", gradation, "--proof", proof});
  CHECK(contains(solved.out, "the gradation is in " + proof + ".gradation.csv"));
  CHECK(mdm_check(proof + ".gradation.csv", proof).exit_code == 0);
  const std::string sample = packed(folder, "s.csv", "size_mm,quantity\n1.5,3\n3,1\n"), of = folder / "s";
  const Outcome verified = mdm({"verify", gradation, sample, "--proof", of});
  CHECK(contains(verified.out, "mdm-check " + of + ".gradation.csv " + of + ".sample.csv " + of));
  CHECK(mdm_check({of + ".gradation.csv", of + ".sample.csv", of}).exit_code == 0);
}

} // namespace gzip_test
