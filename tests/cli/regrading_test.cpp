// mdm convert: two files made one, and gradations changed; hand-made cases, and what is refused. Random cases
// are in tests/regrading.

#include "run.hpp"

namespace regrading_test {

using namespace cli_test;

namespace {

/// The lines of a file that are no comments.
std::string table_of(const std::string &csv) {
  std::string table;
  for (const std::string &line : lines_of(csv))
    if (!line.starts_with('#'))
      table += line + "\n";
  return table;
}

/// Half of the sample passes 75 um.
const std::string sieves = "size_mm,retained_g\n2,0\n0.425,30\n0.15,10\n0.075,10\npan,50\n";
const std::string hydrometer = "size_mm,passing_percent\n0.15,100\n0.075,80\n0.02,40\n0.002,20\npan,0\n";
const std::string coarse = "size_mm,retained_g\n20,0\n10,300\n5,100\n";
const std::string fine = "size_mm,retained_g\n5,0\n1,30\n0.1,10\npan,10\n";

} // namespace

TEST_CASE("sieves and a hydrometer are joined at a sieve of both", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("sieves.csv", sieves), f = folder.write("hydrometer.csv", hydrometer);
  const Outcome joined = mdm({"convert", "--join", c, f, "--at", "75um", "--quiet"});
  CHECK(joined.exit_code == 0);
  CHECK(joined.err.empty());
  // 80 points of the hydrometer's are the 50 g: 20, 20 and 40 points are 12.5, 12.5 and 25 g.
  CHECK(table_of(joined.out) ==
        "size_mm,mass\n0,12.5\n0.002,12.5\n0.02,25\n0.075,10\n0.15,10\n0.425,30\n2,0\n");
  CHECK(contains(joined.out, "# joined at 0.075 mm: " + c + " above, " + f + " below\n"));
  CHECK(contains(joined.out,
                 "# 50 % passes 0.075 mm: the mass 50 of 100 in " + c + "; in " + f + " it is 80\n"));
  CHECK(contains(joined.out, "multiplied by 5/8\n"));
  // The hydrometer's whole would be 62.5 % of the sample.
  CHECK(contains(joined.out, "# compared at 0.15 mm: 60 % passes in " + c + ", 62.5 % in " + f + "\n"));
  CHECK(contains(joined.out, "# left out of " + f + ": what it has at 0.15 mm\n"));
  const std::string path = folder.write("joined.csv", joined.out);
  CHECK(mdm({"solve", path, "--proof", folder / "proof"}).exit_code == 0);
  CHECK(mdm_check(path, folder / "proof").exit_code == 0);
}

TEST_CASE("the finer file may be in another unit", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("sieves.csv", sieves),
                    f = folder.write("laser.csv", "size_um,retained_percent\n75,0\n20,60\n2,40\n");
  CHECK(table_of(mdm({"convert", "--join", c, f, "--at", "75um"}).out) ==
        "size_mm,mass\n0.002,20\n0.02,30\n0.075,10\n0.15,10\n0.425,30\n2,0\n");
  CHECK(table_of(mdm({"convert", "--join", c, f, "--at", "0.075"}).out)
            .starts_with("size_mm,mass\n0.002,20\n"));
}

TEST_CASE("a part that was sieved for the whole has the mass of the whole", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("coarse.csv", coarse), f = folder.write("fine.csv", fine),
                    with_pan = folder.write("pan.csv", coarse + "pan,600\n");
  const std::string table = "size_mm,mass\n0,120\n0.1,120\n1,360\n5,100\n10,300\n20,0\n";
  CHECK(table_of(mdm({"convert", "--split", c, f, "--at", "5mm", "--fine-mass", "600"}).out) == table);
  CHECK(table_of(mdm({"convert", "--split", with_pan, f, "--at", "5"}).out) == table);
  CHECK(table_of(mdm({"convert", "--split", with_pan, f, "--at", "5", "--fine-mass", "6e2"}).out) == table);
  check_refused(mdm({"convert", "--split", c, f, "--at", "5"}), "no mass below 5 mm");
  check_refused(mdm({"convert", "--split", with_pan, f, "--at", "5", "--fine-mass", "599"}),
                "the mass 600 passes 5 mm, and 599 was given");
  const std::string finer = folder.write("finer.csv", "size_mm,retained_g\n4,0\n1,30\npan,10\n");
  check_refused(mdm({"convert", "--split", c, finer, "--at", "4", "--fine-mass", "600"}),
                "finest sieve is 5 mm");
  check_refused(mdm({"convert", "--split", with_pan, f, "--at", "1mm"}), "no sieve of 1 mm");
  const std::string too_coarse = folder.write("too.csv", "size_mm,retained_g\n10,0\n5,1\n1,30\npan,10\n");
  check_refused(mdm({"convert", "--split", with_pan, too_coarse, "--at", "5"}), "no part of what passes it");
  const std::string percents = folder.write("percents.csv", "size_mm,retained_percent\n20,0\n10,60\n5,40\n");
  check_refused(mdm({"convert", "--split", percents, f, "--at", "5", "--fine-mass", "600"}),
                "--fine-mass: it is a mass beside masses");
}

TEST_CASE("a joint that is no exact cut is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("sieves.csv", sieves), f = folder.write("hydrometer.csv", hydrometer);
  check_refused(mdm({"convert", "--join", c, f, "--at", "0.1"}),
                c + ": there is no sieve of 0.1 mm for the joint, and mass between 0.075 mm and 0.15 mm");
  const std::string other = folder.write("other.csv", "size_mm,passing_percent\n0.2,100\n0.06,48\npan,0\n");
  check_refused(mdm({"convert", "--join", c, other, "--at", "75um"}),
                other + ": there is no sieve of 0.075 mm");
  const std::string all = folder.write("all.csv", "size_mm,mass\n0.075,1\n0.15,0\n");
  check_refused(mdm({"convert", "--join", c, all, "--at", "75um"}), "all.csv: nothing passes 0.075 mm");
  check_refused(mdm({"convert", "--join", all, f, "--at", "75um"}), "all.csv: nothing passes 0.075 mm");
  const std::string tolerant =
      folder.write("t.csv", "size_mm,mass,tolerance_percent\n0.02,5,1\n0.075,1,1\n0.15,0,0\n");
  check_refused(mdm({"convert", "--join", tolerant, f, "--at", "75um"}), "it has tolerances");
}

TEST_CASE("a joint in a wrong unit, and files in the wrong order, are told", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("c.csv", "size_mm,mass\npan,40\n0.075,20\n1,30\n2,10\n4,0\n"),
                    f = folder.write("f.csv", "size_um,mass\n2,7\n20,11\n75,0\n");
  CHECK(mdm({"convert", "--join", c, f, "--at", "75um"}).exit_code == 0);
  check_refused(mdm({"convert", "--join", c, f, "--at", "75"}), "c.csv: it has no mass above 75 mm");
  check_refused(mdm({"convert", "--join", f, c, "--at", "75um"}), "f.csv: it has no mass above 75 um");
  const std::string whole = folder.write("whole.csv", "size_mm,mass\n0.002,10\n0.075,50\n1,40\n2,0\n");
  CHECK(mdm({"convert", "--join", c, whole, "--at", "75um"})
            .out.find("\n# more than 100 % passes 1 mm in " + whole + ", measured by " + c +
                      ": check the unit of "
                      "--at and the order of the files\n") != std::string::npos);
  const std::string part = folder.write("part.csv", "size_mm,mass\n0.002,10\n0.075,0\n");
  CHECK(mdm({"convert", "--join", c, part, "--at", "75um"}).exit_code == 0);
}

TEST_CASE("options of joining that do not go together are refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string c = folder.write("c.csv", coarse), f = folder.write("f.csv", fine);
  check_refused(mdm({"convert"}), "FILE is required");
  check_refused(mdm({"convert", c, "--at", "5"}), "--at is about two files");
  check_refused(mdm({"convert", c, "--fine-mass", "5"}), "--fine-mass is about two files");
  check_refused(mdm({"convert", "--join", c, f}), "--join needs --at");
  check_refused(mdm({"convert", "--join", c, "--at", "5"}), "--join");
  check_refused(mdm({"convert", "--join", c, f, "--at", "5", "--fine-mass", "1"}),
                "--fine-mass is of --split");
  check_refused(mdm({"convert", "--join", c, f, "--split", c, f, "--at", "5"}), "exclude each other");
  check_refused(mdm({"convert", c, "--join", c, f, "--at", "5"}), "leave it out");
  check_refused(mdm({"convert", "--join", "-", "-", "--at", "5"}), "standard input is one file");
  check_refused(mdm({"convert", "--join", c, f, "--at", "5", "-o", f}), "");
  check_refused(mdm({"convert", "--join", c, f, "--at", "0"}), "--at");
  check_refused(mdm({"convert", "--join", c, f, "--at", "5 furlongs"}), "--at");
  check_refused(mdm({"convert", "--split", c, f, "--at", "5", "--fine-mass", "0"}), "--fine-mass");
  check_refused(mdm({"convert", c, "--scalp", "above:10", "--dry-run"}), "--dry-run");
}

TEST_CASE("grains above a sieve are left out, or replaced by as much mass of others", "[cli]") {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("fill.csv", "size_mm,mass\n60,0\n40,10\n20,20\n10,30\n5,30\n2,10\n0,0\n");
  const Outcome scalped = mdm({"convert", path, "--scalp", "above:20mm"});
  CHECK(table_of(scalped.out) == "size_mm,mass\n0,0\n2,10\n5,30\n10,30\n20,0\n");
  CHECK(contains(scalped.out, "# scalped: the mass 30 of 100 above 20 mm, 30 %, is left out\n"));
  CHECK(contains(scalped.err, "note: scalped: the mass 30 of 100"));
  // 30 more on the 60 between 5 and 20 mm: half as much again.
  const Outcome replaced = mdm({"convert", path, "--replace", "above:20mm", "into", "5mm..20mm"});
  CHECK(table_of(replaced.out) == "size_mm,mass\n0,0\n2,10\n5,45\n10,45\n20,0\n");
  CHECK(contains(replaced.out, "is now between 5 mm and 20 mm, where it was 60\n"));
  // 10 more on the 90 between 2 and 40 mm is 10/9 of each: all masses are multiplied by 9.
  const Outcome multiplied = mdm({"convert", path, "--replace", "above:40mm", "into", "2..40"});
  CHECK(table_of(multiplied.out) == "size_mm,mass\n0,0\n2,100\n5,300\n10,300\n20,200\n40,0\n");
  CHECK(contains(multiplied.out, "# all masses are multiplied by 9, so that they are decimals\n"));
  for (const char *size : {"above:3mm", "above:1mm", "20mm", "below:20mm", "above:", "above:-1"})
    check_refused(mdm({"convert", path, "--scalp", size}), "--scalp");
}

TEST_CASE("a replacement by grains that are not there, or not finer, is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("fill.csv", "size_mm,mass\n60,0\n40,10\n20,20\n10,0\n5,0\n2,10\n0,0\n");
  const auto refused = [&path](const char *above, const char *into, const char *range, const char *why) {
    check_refused(mdm({"convert", path, "--replace", above, into, range}), why);
  };
  refused("above:40", "into", "5..20", "there is no mass between 5 mm and 20 mm");
  refused("above:40", "into", "20..5", "give the finer size first");
  refused("above:20", "into", "20..60", "give a size of at most 20 mm");
  refused("above:30", "into", "2..5", "there is no sieve of 30 mm for replacing");
  refused("above:40", "into", "3..5", "there is no sieve of 3 mm for the finer end");
  refused("above:40", "into", "2..30", "there is no sieve of 30 mm for the coarser end");
  refused("above:40", "to", "2..5", "is not the word into");
  refused("above:40", "into", "2-5", "is not FROM..TO");
  refused("40", "into", "2..5", "is not above:SIZE");
}

TEST_CASE("a parallel gradation has all sizes in one ratio", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("fill.csv", "size_mm,mass\n60,0\n40,10\n5,20\n0,7\n");
  const std::string table = "size_mm,mass\n0,7\n1,20\n8,10\n12,0\n";
  CHECK(table_of(mdm({"convert", path, "--parallel", "1/5"}).out) == table);
  CHECK(table_of(mdm({"convert", path, "--parallel", "0.2"}).out) == table);
  CHECK(contains(mdm({"convert", path, "--parallel", "1/5"}).out,
                 "# parallel gradation: all sizes times 1/5, the largest sieve from 60 mm to 12 mm\n"));
  // Scalping comes first, whatever the order of the options.
  CHECK(table_of(mdm({"convert", path, "--parallel", "1/5", "--scalp", "above:40"}).out) ==
        "size_mm,mass\n0,7\n1,20\n8,0\n");
  check_refused(mdm({"convert", path, "--parallel", "1/3"}), "is no decimal");
  for (const char *wrong : {"0", "-1", "1/0", "1/-5", "a", "1/5/2", ""})
    check_refused(mdm({"convert", path, "--parallel", wrong}), "--parallel");
  check_refused(mdm({"convert", path, "--parallel", "20%"}), "write the ratio of the sizes, as 0.2 or 1/5");
}

TEST_CASE("factors of one file alone are refused where two are joined", "[cli]") {
  const TemporaryFolder folder;
  const std::string coarse_part = folder.write(
                        "c.csv", "size_mm,mass,factor\n0.02,50,2.65\n0.075,20,2.65\n0.15,0,2.65\n"),
                    fine_part = folder.write("f.csv", "size_mm,mass\n0.002,30\n0.02,60\n0.075,0\n");
  check_refused(mdm({"convert", "--join", coarse_part, fine_part, "--at", "0.075mm"}),
                "its classes have factors");
}

TEST_CASE("percents that become masses are told to have been rounded", "[cli]") {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("p.csv", "size_mm,passing_percent\n0.075,10\n0.15,40\n0.3,70\n0.6,100\n");
  for (const Arguments &change : std::vector<Arguments>{
           {"--scalp", "above:0.3mm"}, {"--replace", "above:0.3mm", "into", "0.075mm..0.3mm"}}) {
    Arguments all{"convert", path};
    all.insert(all.end(), change.begin(), change.end());
    CHECK(contains(mdm(all).out, "were rounded to their last digit; here they are masses"));
  }
}

TEST_CASE("a split above the finest sieve of the coarse part is refused where that has weighed there",
          "[cli]") {
  const TemporaryFolder folder;
  const std::string coarse_part = folder.write("co.csv", "size_mm,mass\npan,500\n0.6,300\n1.2,200\n2.4,0\n"),
                    fine_part = folder.write("fi.csv", "size_mm,mass\npan,20\n0.15,30\n0.3,50\n0.6,0\n");
  check_refused(mdm({"convert", "--split", coarse_part, fine_part, "--at", "1.2mm"}),
                "split at its finest sieve, 0.6 mm");
  CHECK(mdm({"convert", "--split", coarse_part, fine_part, "--at", "0.6mm"}).exit_code == 0);
}

TEST_CASE("JSON has no comments: the history is on standard error", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("fill.csv", "size_mm,mass\n60,0\n40,10\n5,20\n0,7\n");
  const Outcome json = mdm({"convert", path, "--scalp", "above:40", "--format", "json"});
  CHECK(json.out ==
        "{\"id\": \"fill\", \"unit\": \"mm\", \"sizes\": [\"0\", \"5\", \"40\"], \"masses\": [\"7\", \"20\", "
        "\"0\"]}\n");
  CHECK(contains(json.err, "scalped"));
}

} // namespace regrading_test
