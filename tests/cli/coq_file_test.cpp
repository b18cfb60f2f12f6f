// solve --coq writes a whole file or none.

#include "run.hpp"

#include <cmath>

namespace coq_file_test {

using namespace cli_test;

namespace {

/// A sand whose proof within a small tolerance is long.
std::string long_proof(const TemporaryFolder &folder) {
  const std::string path = folder / "sand.csv";
  std::ofstream(path)
      << "size_mm,mass\n0.05,1.1\n0.07,18.3\n0.084,16.8\n0.109,16.6\n0.142,17.1\n0.169,25.6\n0.219,10.0\n0."
         "261,14.1\n0.311,19.3\n0.404,1.9\n0.569,22.4\n0.74,20.2\n1.044,1.4\n1.357,3.3\n1.913,10.2\n2.697,11."
         "0\n3.21,13.5\n4.173,18.6\n5.883,19.1\n8.295,13.8\n10.784,0\n";
  return path;
}

} // namespace

TEST_CASE("the file has the theorem, the command that checks it, and no name that ends the comment") {
  const TemporaryFolder folder;
  const std::string sand = folder / "a *) \"b.csv";
  std::ofstream(sand) << "size_mm,mass\n1,2\n2,1\n3,0\n";
  CHECK(mdm({"solve", sand, "--coq", folder / "sand.v", "--quiet"}).exit_code == 0);
  const std::string text = read_file(folder / "sand.v");
  CHECK(text.find("a ?) ?b.csv, checked by") != std::string::npos);
  CHECK(text.find(" Mdm sand.v\n") != std::string::npos);
  CHECK(text.find("a *) \"\"b.csv\"\n\"size_mm,mass\n1,2\n2,1\n3,0\n\".\n") != std::string::npos);
  CHECK(text.find("File \"certificate\"\n\"mdm-certificate 1\nlaw 3\nparticles 4\n") != std::string::npos);
  CHECK(text.find("Print Assumptions answer.\n") == text.size() - 26);
}

TEST_CASE("the file names a gradation from standard input as the verdicts do") {
  const TemporaryFolder folder;
  CHECK(
      mdm({"solve", "-", "--coq", folder / "sand.v", "--quiet"}, "size_mm,mass\n1,2\n2,1\n3,0\n").exit_code ==
      0);
  CHECK(read_file(folder / "sand.v").find("file := File \"standard input\"\n\"size_mm,mass\n1,2\n") !=
        std::string::npos);
}

TEST_CASE("the certificate in the file is that of --proof, the gradation of a band alone the band's file") {
  const TemporaryFolder folder;
  const std::string band = example("c33-fine-aggregate-limits");
  CHECK(
      mdm({"solve", "--band", band, "--coq", folder / "band.v", "--proof", folder / "band.proof", "--quiet"})
          .exit_code == 0);
  const std::string text = read_file(folder / "band.v");
  CHECK(text.find("\"" + read_file(folder / "band.proof") + "\"") != std::string::npos);
  CHECK(text.find(read_file(band)) != std::string::npos);
}

TEST_CASE("a name that Coq does not take, or that another file has, is refused") {
  const TemporaryFolder folder;
  for (const char *name : {"sand", "sand-1.v", "1.v", ".v", "sand.vo", "sa nd.v"})
    check_refused(mdm({"solve", example("athabasca-sand"), "--coq", folder / name}),
                  "--coq: Coq takes file names");
  check_refused(mdm({"solve", example("athabasca-sand"), "--coq", "-"}), "--coq: Coq takes file names");
  for (const char *option : {"--proof", "--vipr", "-o"})
    check_refused(mdm({"solve", example("athabasca-sand"), "--coq", folder / "a.v", option, folder / "a.v"}));
  CHECK(!std::filesystem::exists(folder / "a.v"));
}

TEST_CASE("a proof that is too long for Coq is refused, and nothing is written") {
  const TemporaryFolder folder;
  const std::string narrow =
      folder.write("narrow.csv", "size_mm,mass\n1,11\n1.000001,12\n1.000002,15\n1.000003,11\n1.000004,0\n");
  check_refused(mdm({"solve", narrow, "--quiet", "--coq", folder / "sand.v", "-o", folder / "answer"}),
                "Coq's stack holds no more than 30000");
  CHECK(!std::filesystem::exists(folder / "sand.v"));
  CHECK(!std::filesystem::exists(folder / "answer"));
}

TEST_CASE("a proof with too many windows for Coq is refused, and nothing is written") {
  const TemporaryFolder folder;
  // A hundred classes in equal ratios: masses of many sizes are nearly as good.
  std::string rows = "size_um,mass\n";
  double x = 1000;
  for (int j = 0; j < 100; ++j, x *= 1.0865)
    rows += std::to_string(std::lround(x)) + ",1\n";
  const std::string flat = folder.write("flat.csv", rows + std::to_string(std::lround(x)) + ",0\n");
  check_refused(mdm({"solve", flat, "--tolerance", "retained:5%", "--quiet", "--coq", folder / "sand.v"}),
                "where windows times classes are more than 4000");
  CHECK(!std::filesystem::exists(folder / "sand.v"));
}

TEST_CASE("where a limit ends the search the theorem is of the bounds, and a note says so") {
  const TemporaryFolder folder;
  const Outcome outcome = mdm({"solve", long_proof(folder), "--tolerance", "retained:0.4%", "--node-limit",
                               "1", "--coq", folder / "sand.v"});
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.out.find("the proof is of the bounds: N is at least ") != std::string::npos);
  CHECK(read_file(folder / "sand.v").find("particles ") != std::string::npos);
}

} // namespace coq_file_test
