// The places where the program could round a number of the user's: nowhere but in the files listed here.

#include "support.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace rounding_test {

namespace {

/// A way to give another number than the one that was read, and the files that may use it.
struct Rounding {
  std::string name;
  std::set<std::string> files;
  std::string why;
};

const std::vector<Rounding> roundings = {
    {"PhiReading::rounded",
     {"answer/answer_reader.cpp", "cli/convert.cpp", "cli/regrading_flags.cpp", "gradation/csv_reader.cpp"},
     "mdm convert alone asks for it"},
    {"phi_size(",
     {"gradation/phi.hpp", "gradation/phi.cpp", "gradation/csv_rows.cpp", "gradation/envelope.cpp",
      "gradation/row_sizes.cpp", "gradation/sieve_series.cpp"},
     "whole phi, what mdm convert writes, the remedy in a message, and generated sieves"},
    {"nearest_decimal(",
     {"gradation/root_size.hpp", "gradation/root_size.cpp", "gradation/shown.cpp"},
     "the printed form of irrational openings, and messages"},
    {"to_digits(",
     {"gradation/mass_digits.hpp", "gradation/mass_digits.cpp"},
     "--round, the user's own word"},
    {"drawn_size(",
     {"gradation/root_size.hpp", "gradation/root_size.cpp", "ask/plot.cpp", "plot/curves_figure.cpp",
      "plot/gradation_figure.cpp", "plot/tradeoff_figure.cpp"},
     "pictures"},
    {"parse_decimal(rounded(",
     {"sets/matched_set.cpp", "sets/suite_sieves.cpp"},
     "generate --match-digits, the user's own word, and generated sieves"},
    {"convert_to<double>",
     {"ask/export_model.cpp",          "ask/export_report.cpp",         "match/near.hpp",
      "packing/apollonian.cpp",        "packing/apollonian_walk.hpp",   "packing/lattice.cpp",
      "particles/cohesion.cpp",        "particles/contact_table.cpp",   "particles/gsd_writer.cpp",
      "particles/material_table.cpp",  "particles/mixed_placement.cpp", "particles/model_lammps.cpp",
      "particles/model_liggghts.cpp",  "particles/model_yade.cpp",      "particles/placed_writer.cpp",
      "particles/sample_set.cpp",      "particles/settle_model.cpp",    "particles/settle_script.cpp",
      "particles/triaxial_phases.cpp", "particles/triaxial_shear.cpp",  "plot/curves_figure.cpp",
      "plot/gradation_figure.cpp",     "plot/limits_series.cpp",        "plot/ranges.hpp",
      "plot/texture_figure.cpp",       "plot/tradeoff_figure.cpp",      "sets/inverse_model.cpp"},
     "lengths of boxes, times, forces and materials in engines, and pictures; bounds of packings, and what "
     "steers "
     "the search for a match, with an exact test behind them"},
    {"mpq_get_d(",
     {"match/near.hpp", "packing/sphere_sample.cpp", "particles/written_number.cpp"},
     "decimals and doubles in particle files, judged exactly, and places and what steers the search with an "
     "exact test behind them"},
    {"mpz_get_d(", {"match/sweep_problem.cpp"}, "bounds of the sweep, with an exact fallback"},
    {"to_double(",
     {"match/sweep_problem.hpp", "match/sweep_problem.cpp", "match/least_match.cpp", "number/int128.hpp",
      "papers/accessible_report.cpp", "papers/inverse_report.cpp", "papers/packing_figures.cpp",
      "plot/ranges.hpp", "plot/timesteps_figure.cpp", "plot/triaxial_figure.cpp", "papers/paper_figures.cpp",
      "papers/size_model_figures.cpp"},
     "bounds of the sweep, with an exact fallback, and pictures"},
    {"strtod(",
     {"ask/export_model.cpp", "number/nearest_double.cpp", "particles/gsd_writer.cpp"},
     "places that were written as doubles, and floats; numbers of workbooks, which are doubles"},
    {"stod(", {}, ""},
    {"atof(", {}, ""}};

/// True if the code of a line, its comment aside, has the name, and not within a longer one.
bool uses(const std::string &line, const std::string &name) {
  const std::string code = line.substr(0, line.find("//"));
  for (std::size_t at = code.find(name); at != std::string::npos; at = code.find(name, at + 1))
    if (at == 0 || (std::isalnum(static_cast<unsigned char>(code[at - 1])) == 0 && code[at - 1] != '_'))
      return true;
  return false;
}

/// The sources of the solver with the path behind src/ or include/mdm/; the checker shares nothing with them.
std::map<std::string, std::filesystem::path> sources() {
  std::map<std::string, std::filesystem::path> all;
  for (const std::string folder : {"/src", "/include/mdm"}) {
    const std::filesystem::path root = std::string(MDM_SOURCE_DIR) + folder;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(root)) {
      const std::string path = std::filesystem::relative(entry.path(), root).string();
      if ((path.ends_with(".cpp") || path.ends_with(".hpp")) && !path.starts_with("checker/"))
        all.emplace(path, entry.path());
    }
  }
  return all;
}

} // namespace

TEST_CASE("only the listed files could round a number of the user's") {
  std::map<std::string, std::set<std::string>> found;
  for (const auto &[path, file] : sources()) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      for (const Rounding &rounding : roundings)
        if (uses(line, rounding.name))
          found[rounding.name].insert(path);
  }
  for (const Rounding &rounding : roundings) {
    INFO(rounding.name << ": " << rounding.why);
    CHECK(found[rounding.name] == rounding.files);
  }
}

} // namespace rounding_test
