// Gradations of several materials, from the file to the verdict.

#include "answer.hpp"
#include "proved.hpp"
#include "replaced.hpp"

namespace material_gradation_test {

using namespace cli_test;
using mdm_test::replaced;

namespace {

const std::string beach =
    "size_mm,mass,factor,material\n0.5,3,2.65,quartz\n1,5,2.65,quartz\n2,0,2.65,quartz\n"
    "0.5,1,2.75,shell\n2,1,2.75,shell\n4,0,2.75,shell\n";
/// The same table in another order, with other words.
const std::string shuffled =
    "# a beach\nsize_mm;retained_g;material;factor\n4;0;shell;2,75\n2;0;quartz;2,65\n2;1;\"shell\";2,75\n"
    "0,5;1;shell;2,75\n1;5;quartz;2,65\n0,5;3;quartz;2,65\n";

struct Proved : ProvedGradation {
  explicit Proved(const Arguments &options = {}, int exit_code = 0, const std::string &content = beach)
      : ProvedGradation("beach", content, options, exit_code) {}
  /// The verdict with another gradation file.
  int beside(const std::string &content) const {
    return mdm_check(folder.write("other.csv", content), proof).exit_code;
  }
};

} // namespace

TEST_CASE("the smallest set of several materials has a proof", "[cli]") {
  const Proved proved;
  CHECK(contains(proved.text, "the smallest set that matches exactly"));
  CHECK(contains(proved.text, "shell"));
  const Outcome verdict = proved.verdict();
  CHECK(verdict.exit_code == 0);
  CHECK(contains(verdict.out, "factors from the file; classes of the materials \"quartz\", \"shell\")"));
  CHECK(proved.beside(shuffled) == 0);
}

TEST_CASE("options of exact matches hold for several materials, and have proofs", "[cli]") {
  for (const Arguments &options :
       std::vector<Arguments>{{"--min-per-class", "7"},
                              {"--at-least", "500"},
                              {"--size-factor", "3"},
                              {"--law", "power:5/2"},
                              {"--solids-volume", "5000"},
                              {"--specimen", "cylinder:20x40", "--void-ratio", "0.6"}}) {
    const Proved proved(options);
    INFO(read_file(proved.proof));
    CHECK(proved.verdict().exit_code == 0);
  }
}

TEST_CASE("the smallest set of several materials within a tolerance has a proof", "[cli]") {
  for (const Arguments &options : std::vector<Arguments>{
           {"--tolerance", "retained:1%"},
           {"--tolerance", "total:5%"},
           {"--tolerance", "retained:2%", "--tolerance", "total:3%", "--min-per-class", "2"},
           {"--tolerance", "retained:1%", "--at-least", "500"},
           {"--tolerance", "total:0.1%", "--solids-volume", "5000"}}) {
    const Proved proved(options);
    INFO(read_file(proved.proof));
    const Outcome verdict = proved.verdict();
    CHECK(verdict.exit_code == 0);
    CHECK(contains(verdict.out, "within a tolerance"));
    CHECK(contains(verdict.out, "classes of the materials \"quartz\", \"shell\""));
    CHECK(proved.beside(shuffled) == 0);
    CHECK(proved.beside(replaced(beach, "1,5,2.65", "1,9,2.65")) == 1);
  }
}

TEST_CASE("forged certificates of several materials within a tolerance are refused", "[cli]") {
  const Proved proved({"--tolerance", "retained:1%"});
  CHECK(proved.forged("particles 29", "particles 28") == 1);
  CHECK(proved.forged("retained 1\n", "retained 2\n") == 1);
  CHECK(proved.forged("retained 1\n", "retained 0.9\n") == 1);
  CHECK(proved.forged("retained 1\n", "passing 1\n") == 1);
  CHECK(proved.forged("retained 1\n", "retained file\n") == 1);
  CHECK(proved.forged("class 4 1 ", "class 3 1 ") == 1);
}

TEST_CASE("the shares of an answer within a tolerance are those of its classes", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach);
  CHECK(contains(mdm({"solve", file, "--tolerance", "total:5%"}).out,
                 "retained (%)  achieved  quantity  size of a particle (mm)\n"));
  CHECK(
      contains(mdm({"solve", file, "--tolerance", "retained:1%"}).out,
               "      4  shell     (0.5, 2]                            10   9 .. 11  9.001282         1  ["));
  const Json answer = solve_json({file, "--tolerance", "retained:1%"});
  CHECK(answer["achieved"].size() == 4);
  CHECK(answer["tolerance"]["retained"].size() == 4);
  const std::string saved = folder.write("answer.json", answer.dump());
  CHECK(mdm({"verify", file, saved, "--tolerance", "retained:1%"}).exit_code == 0);
  CHECK(mdm({"verify", file, saved, "--tolerance", "retained:0.9%"}).exit_code == 1);
}

TEST_CASE("a search over several materials that reaches its limit has a proof of the bounds", "[cli]") {
  const std::string narrow =
      "size_mm,mass,material\n1,1,a\n1.0001,0,a\n0.7,2,b\n0.70001,0,b\n0.1,3,c\n0.2,0,c\n";
  const Proved proved({"--max-steps", "20"}, 3, narrow);
  const Outcome verdict = proved.verdict();
  CHECK(verdict.exit_code == 0);
  CHECK(contains(verdict.out, "is between"));
}

TEST_CASE("forged certificates of several materials are refused", "[cli]") {
  const Proved proved({"--min-per-class", "2"});
  const std::string certificate = read_file(proved.proof);
  const std::string n = certificate.substr(certificate.find("particles ") + 10,
                                           certificate.find("\nscale") - certificate.find("particles ") - 10);
  CHECK(proved.forged("particles " + n, "particles " + std::to_string(std::stoi(n) - 1)) == 1);
  CHECK(proved.forged("particles " + n, "particles " + std::to_string(std::stoi(n) + 1)) == 1);
  CHECK(proved.forged("class 4 ", "class 3 ") == 1);
  CHECK(proved.forged("class 5 ", "class 6 ") == 1);
  CHECK(proved.forged("chain ", "chain 3 ") == 1);
  CHECK(proved.forged("chain ", "chain 6 ") == 1);
  CHECK(proved.forged("min-per-class 2\n", "min-per-class 200\n") == 1);
  CHECK(proved.forged("law 3\n", "law 2\n") == 1);
  CHECK(proved.forged("min-per-class 2\n", "cut-below 1\nmin-per-class 2\n") == 1);
  CHECK(proved.forged("end\n", "end\nend\n") == 2);
  CHECK(proved.forged("min-per-class 2\n", "retained 1\n") == 2);
}

TEST_CASE("a proof of one gradation of several materials is none of another", "[cli]") {
  const Proved proved;
  CHECK(proved.beside(replaced(beach, "0.5,1,2.75,shell", "0.5,1,2.75,quarry")) == 2);
  CHECK(proved.beside(replaced(beach, "1,5,2.65", "1,5.1,2.65")) == 1);
  CHECK(proved.beside(replaced(beach, "2,1,2.75", "2,1,2.7")) == 1);
  std::string swapped = beach;
  for (const auto &[from, to] : {std::pair{",quartz", ",Quartz"}, std::pair{",shell", ",A shell"}})
    for (std::size_t at = 0; (at = swapped.find(from, at)) != std::string::npos;)
      swapped.replace(at, std::string(from).size(), to);
  CHECK(proved.beside(swapped) == 1); // "A shell" is before "Quartz"
  CHECK(proved.beside("size_mm,mass,factor\n0.5,3,2.65\n1,5,2.65\n2,0,2.65\n") == 1);
  CHECK(proved.beside("size_mm,mass\n0.5,3\n1,5\n2,0\n2.5,1\n3,1\n4,0\n") == 1);
}

TEST_CASE("mdm-check reads the column of materials as mdm does", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string &content :
       {std::string("size_mm,mass,material\n1,1,a\n2,0,a\n4,0,b\n"),
        std::string("size_mm,mass,material\n1,1,a\n2,0,a\n1,1,b\n4,1,b\n"),
        std::string("size_mm,mass,material\n1,1,a\n2,0,a\n1,1,a\n"),
        std::string("size_mm,mass,material\n1,1,\n2,0,\n"), std::string("size_mm,mass,material\n"),
        std::string("size_mm,mass,material\n1,1,\" a\"\n2,0,\" a\"\n"),
        "size_mm,mass,material\n1,1," + std::string(101, 'a') + "\n2,0," + std::string(101, 'a') + "\n",
        std::string("size_mm,mass,material,material\n1,1,a,a\n2,0,a,a\n"),
        std::string("size_mm,passing_percent,material\n1,0,a\n2,100,a\n"),
        std::string("size_mm,retained_percent,material\n1,100,a\n2,0,a\n"),
        std::string("size_mm,number_percent,material\n1,100,a\n2,0,a\n"),
        std::string("size_mm,mass,tolerance_percent,material\n1,1,1,a\n2,0,1,a\n"),
        std::string("material,size_mm,mass\na,1,1\na,2,0\n")}) {
    INFO(content);
    const std::string file = folder.write("bad.csv", content);
    check_refused(mdm({"solve", file}));
    CHECK(mdm_check({"--print", file}).exit_code == 2);
  }
  const std::string file = folder.write("beach.csv", shuffled);
  const Outcome printed = mdm_check({"--print", file});
  CHECK(printed.out == "size_mm,mass,factor,material\n0.5,3,2.65,\"quartz\"\n1,5,2.65,\"quartz\"\n"
                       "2,0,2.65,\"quartz\"\n0.5,1,2.75,\"shell\"\n2,1,2.75,\"shell\"\n4,0,2.75,\"shell\"\n");
  CHECK(mdm_check({"--print", folder.write("printed.csv", printed.out)}).out == printed.out);
}

TEST_CASE("names of materials are shown as they are, and cannot lie", "[cli]") {
  const std::string odd =
      "size_mm,mass,material\n1,1,\"a \"\"b\"\", c\"\n2,0,\"a \"\"b\"\", c\"\n1,2,d\n3,0,d\n";
  const Proved proved({"--format", "csv"}, 0, odd);
  CHECK(contains(proved.text, ",\"a \"\"b\"\", c\"\n"));
  CHECK(contains(proved.verdict().out, "classes of the materials \"a \\\"b\\\", c\", \"d\")"));
}

TEST_CASE("answers to several materials have all formats", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach);
  const Json answer = solve_json({file});
  REQUIRE(answer["classes"].size() == 4);
  CHECK(answer["classes"][1]["material"] == "quartz");
  CHECK(answer["classes"][2]["material"] == "shell");
  CHECK(answer["classes"][2]["lower"] == "0.5");
  CHECK(answer["classes"][2]["upper"] == "2");
  const std::string csv = mdm({"solve", file, "--format", "csv"}).out;
  CHECK(contains(csv, "lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm,material\n0.5,1,3,"));
  CHECK(lines_of(csv).size() == 5);
  const std::string plain = folder.write("plain.csv", "size_mm,mass\n1,1\n2,0\n");
  CHECK_FALSE(contains(mdm({"solve", plain, "--format", "json"}).out, "material"));
}

TEST_CASE("what says nothing of several materials is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach);
  for (const Arguments &options : std::vector<Arguments>{{"--cut-below", "1"},
                                                         {"--pan-size", "0.1"},
                                                         {"--particles", "10"},
                                                         {"--spread"},
                                                         {"--coq", folder / "sand.v"},
                                                         {"--unit", "mm"}}) {
    Arguments arguments{"solve", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    check_refused(mdm(arguments), options.front() + ": it is of gradations of one material");
  }
}

TEST_CASE("tolerances on what passes are none of several materials", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach);
  for (const std::string tolerance :
       {"passing:1%", "passing:file", "retained:file", "laboratory", "rounding"})
    check_refused(mdm({"solve", file, "--tolerance", tolerance}),
                  "tolerance " + tolerance +
                      " has no meaning for several materials: use retained:E% or total:E%");
}

TEST_CASE("batch answers gradations of several materials as solve does", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach), proofs = folder / "proofs",
                    mass = folder.write("mass.csv", "size_mm,mass\n1,1\n2,1\n4,0\n");
  const Outcome batch = mdm({"batch", file, mass, "--tolerance", "retained:1%", "--proofs", proofs});
  CHECK(batch.exit_code == 0);
  const std::vector<std::string> lines = lines_of(batch.out);
  REQUIRE(lines.size() == 2);
  const Json one = Json::parse(lines[0]), alone = solve_json({file, "--tolerance", "retained:1%"});
  CHECK(one.at("classes") == alone.at("classes"));
  CHECK(mdm_check(file, proofs + "/000001-beach.proof").exit_code == 0);
  const Outcome csv = mdm({"batch", file, mass, "--format", "csv"});
  CHECK(csv.exit_code == 2);
  CHECK(contains(csv.err, "several materials, for which the CSV has no column"));
  CHECK(contains(csv.out, "mass,1,1,2,50,"));
  const Outcome cut = mdm({"batch", file, "--cut-below", "1"});
  CHECK(cut.exit_code == 2);
  CHECK(contains(cut.out, "--cut-below: it is of gradations of one material"));
  CHECK(contains(mdm({"solve", folder.write("first.csv", "material,size_mm,mass\na,1,1\na,2,0\n")}).err,
                 "write size_mm,mass,material"));
}

TEST_CASE("several materials are nowhere taken as one", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach);
  const std::string mass = folder.write("mass.csv", "size_mm,mass\n1,1\n2,1\n4,0\n");
  const std::string list = folder.write("list.csv", "size_mm,quantity\n1.5,2\n");
  for (const Arguments &arguments : std::vector<Arguments>{{"describe", file},
                                                           {"convert", file},
                                                           {"convert", file, "--kind", "mass"},
                                                           {"tradeoff", file},
                                                           {"published", "rounded", file},
                                                           {"judge", file, "--spec", "astm-c33-fine"},
                                                           {"plot", file, "-o", folder / "a.svg"},
                                                           {"report", file, "-o", folder / "a.html"},
                                                           {"blend", mass, file, "--spec", mass}}) {
    INFO(arguments.front());
    const Outcome outcome = mdm(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "material"));
    CHECK(outcome.out.empty());
  }
  const std::string answer = folder.write("answer.json", mdm({"solve", file, "--format", "json"}).out);
  check_refused(mdm({"verify", mass, answer}), "is of a gradation of several materials");
  check_refused(mdm({"export", answer, "--to", "csv"}), "is of a gradation of several materials");
  CHECK(mdm({"solve", mass, "--proof", folder / "mass.proof"}).exit_code == 0);
  CHECK(mdm_check(file, folder / "mass.proof").exit_code == 1);
  CHECK(mdm({"solve", mass, "--tolerance", "passing:10%", "--proof", folder / "tolerant.proof"}).exit_code ==
        0);
  const Outcome tolerant = mdm_check(file, folder / "tolerant.proof");
  CHECK(tolerant.exit_code == 1);
  CHECK(contains(tolerant.err, "materials: tolerances on what is retained and on the total alone fails"));
  CHECK(mdm({"verify", mass, list, "--proof", folder / "list.proof"}).exit_code == 1);
  CHECK(mdm_check({file, list, folder / "list.proof"}).exit_code == 2);
}

TEST_CASE("particles of several materials are exported, each with its material and density", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("beach.csv", beach), csv = folder / "grains.csv",
                    data = folder / "grains.data";
  const auto exported = [&](Arguments more) {
    Arguments words{"export", file, "--at-least", "200", "--density", "1000"};
    words.insert(words.end(), more.begin(), more.end());
    return mdm(words);
  };
  CHECK(exported({"--to", "csv", "-o", csv}).exit_code == 0);
  CHECK(contains(read_file(csv), "size_m,quantity,material\n"));
  CHECK(mdm({"verify", file, csv, "--tolerance", "1e-6"}).exit_code == 0);
  CHECK(exported({"--to", "lammps", "--types", "class", "-o", data}).exit_code == 0);
  for (const char *part : {"] of quartz\n", "] of shell\n", " 2650 ", " 2750 "})
    CHECK(contains(read_file(data), part));
  check_refused(exported({"--to", "lammps", "--model", "settle", "-o", folder / "x"}),
                "--model: it tells classes by their sizes, and those of several materials overlap");
  check_refused(mdm({"export", file, "--to", "csv", "-o", folder / "x.csv"}),
                "1000 where they are densities in g/cm^3");
  check_refused(exported({"--to", "csv", "--spread", "-o", folder / "x.csv"}),
                "--spread: it is of gradations of one");
  check_refused(exported({"--to", "csv", "--pan-size", "1um", "-o", folder / "x.csv"}),
                "--pan-size: it is of");
}

TEST_CASE("a material whose name cannot be printed is refused", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string name : {"a\tb", "\xEF\xBB\xBF"
                                         "c"})
    check_refused(mdm({"solve", folder.write("m.csv", replaced(beach, "quartz", name))}), "is no name");
}

} // namespace material_gradation_test
