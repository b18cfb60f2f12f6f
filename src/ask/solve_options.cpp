#include "ask/solve_options.hpp"

#include "ask/option_values.hpp"
#include "text/file_names.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <array>
#include <fstream>

namespace mdm {
namespace {

ScaleChoice scale_of(const std::string &text) {
  if (text == "robust")
    return ScaleChoice::robust;
  if (text == "upper")
    return ScaleChoice::upper;
  throw InputError(option("scale") + ": " + in_quotes(text) + " is neither robust nor upper");
}

/// The file as it is.
std::string plain_file(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 4096> piece{};
  while (file && text.size() <= max_gradation_bytes) {
    file.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad())
    throw InputError(shown_name(path) + ": cannot be read: name a file that can be read");
  return text; // read_law_table refuses one that is longer
}

/// The law; of a table by the file's name, or by the text of it, if that has lines.
MassLaw law_of(const std::string &text) {
  if (!text.starts_with(law_by_table))
    return parse_mass_law(text);
  const std::string file = text.substr(law_by_table.size());
  if (file.find('\n') != std::string::npos)
    return read_law_table(file, "table");
  return read_law_table(read_law_file(file), shown_name(file));
}

/// Refuses options beside a budget that chooses the size factor.
void check_factor_budget(const SolveTexts &others) {
  if (!others.specimen && !others.solids_volume)
    throw InputError(
        option("by") + " size-factor: a factor changes the number of particles of a specimen alone: add " +
        option("specimen") + " with " + option("void-ratio") + ", or " + option("solids-volume"));
  for (const auto &[name, text] :
       {std::pair{"size-factor", others.size_factor}, std::pair{"at-most", others.at_most}})
    if (text)
      throw InputError(option(name) + ": it does not go with " + option("by") + " size-factor: leave it out");
}

/// The name of the kind without a value.
std::string kind_of(const SolveTexts &others) {
  return others.tolerances.empty() ? "retained" : others.tolerances.front();
}

} // namespace

std::string (*read_law_file)(const std::string &path) = plain_file;

bool names_kind(std::string_view tolerance) {
  return tolerance == "retained" || tolerance == "passing" || tolerance == "total";
}

const std::vector<OptionRow<GradationTexts>> GradationTexts::options = {
    {"law", "LAW", OptionKind::text,
     "mass of a particle of size x: sphere (x^3), power:a/b or power:2.5, sum:2*x^3+0.5*x^2 with x in mm, or "
     "table:FILE, CSV with size_mm and particle_mass, from (0, 0) on and linear between its rows",
     &GradationTexts::law},
    {"size-factor", "K", OptionKind::number, "multiply every size of the gradation by K",
     &GradationTexts::size_factor},
    {"cut-below", "SIZE", OptionKind::number,
     "leave out the classes below the sieve SIZE, as 63um or in the file's unit (before --size-factor)",
     &GradationTexts::cut_below},
    {"pan-size", "SIZE", OptionKind::number,
     "count the pan as SIZE, as 2um or in the file's unit, instead of 0 (before --size-factor)",
     &GradationTexts::pan_size}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::tolerance_options = {
    {"tolerance", "WHICH", OptionKind::tolerances,
     "the smallest match within a tolerance: retained:1%, passing:0.5%, total:1% (percentage points), "
     "retained:file, passing:file (column tolerance_percent), laboratory, rounding; may be repeated",
     &SolveTexts::tolerances}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::band_options = {
    {"band", "FILE", OptionKind::file,
     "the smallest match within the envelope in FILE: CSV with passing_min_percent and passing_max_percent "
     "of each sieve, or a table with columns such as Lower and Upper",
     &SolveTexts::band}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::question_options = {
    {"min-per-class", "R", OptionKind::number, "at least R particles in every class with mass",
     &SolveTexts::min_per_class},
    {"at-least", "N", OptionKind::number, "the smallest match with at least N particles",
     &SolveTexts::at_least},
    {"specimen", "SHAPE", OptionKind::text,
     "at least the solids of a specimen: cylinder:DxH or box:AxBxC; lengths as 50mm, 63um, 2m, 0.5in, "
     "or in the file's unit (mm for sieve names and phi; beside inches a unit is needed)",
     &SolveTexts::specimen},
    {"void-ratio", "E", OptionKind::number, "void ratio e of the specimen", &SolveTexts::void_ratio},
    {"solids-volume", "V", OptionKind::number,
     "at least this volume of solids, in the cube of the answer's unit", &SolveTexts::solids_volume}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::search_options = {
    {"at-most", "N", OptionKind::number, "no match if the smallest has more than N particles",
     &SolveTexts::at_most}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::answer_options = {
    {"digits", "D", OptionKind::number, "significant digits of sizes (15)", &SolveTexts::digits},
    {"scale", "WHICH", OptionKind::text, "robust (sizes far from the sieves) or upper (largest sizes)",
     &SolveTexts::scale}};

const std::vector<OptionRow<SolveTexts>> SolveTexts::limit_options = {
    {"max-steps", "N", OptionKind::number,
     "stop after so many steps (67108864), with what is certain (exit 3)", &SolveTexts::max_steps},
    {"node-limit", "N", OptionKind::number, "stop after so many nodes of the search for a tolerance (exit 3)",
     &SolveTexts::node_limit},
    {"time-limit", "S", OptionKind::seconds, "stop after so many seconds (exit 3)", &SolveTexts::time_limit},
    {"gap", "G", OptionKind::number,
     "within a tolerance, stop at a match that has at most this part of its particles more than are "
     "certain, for example 1e-6 (exit 0)",
     &SolveTexts::gap}};

const std::vector<OptionRow<BudgetTexts>> BudgetTexts::options = {
    {"particles", "N", OptionKind::number,
     "the least tolerance with which N particles suffice, of the kind that --tolerance names without a "
     "value: retained (as without it), passing or total",
     &BudgetTexts::particles},
    {"by", "WHAT", OptionKind::text,
     "what --particles chooses: tolerance, or size-factor, the least factor with which N particles of a "
     "specimen suffice (tolerance)",
     &BudgetTexts::by},
    {"grid", "STEP", OptionKind::number,
     "the steps of that tolerance in percentage points, or of that factor from 1 on (0.001)",
     &BudgetTexts::grid}};

AskedQuestion GradationTexts::question() const {
  AskedQuestion asked;
  if (law)
    asked.rest.law = named("law", *law, law_of);
  if (pan_size)
    asked.pan_size = length("pan-size", *pan_size);
  if (cut_below)
    asked.cut_below = length("cut-below", *cut_below);
  if (size_factor)
    asked.rest.size_factor = positive("size-factor", *size_factor);
  return asked;
}

void SolveTexts::check_source(const OptionText &file, const std::string &reading,
                              const std::string &command) const {
  if (!file && !band)
    throw InputError("mdm: FILE is required, or " + option("band") + "; see mdm " + command + " " +
                     option("help"));
  if (!file && !reading.empty())
    throw InputError(reading + ": it is of the gradation's FILE, and there is none: leave it out");
  if (file == "-" && band == "-")
    throw InputError(option("band") + ": standard input is the gradation already: give one of them by name");
}

AskedQuestion SolveTexts::question(const ReadBand &read_band) const {
  if (is_tolerant() && scale)
    throw InputError(option("scale") +
                     ": sizes within a tolerance are as far from all bounds as can be: leave it out");
  if (is_tolerant() && max_steps)
    throw InputError(option("max-steps") + ": it is of exact matches: give " + option("node-limit") +
                     ", or " + option("time-limit"));
  if (!is_tolerant() && node_limit)
    throw InputError(option("node-limit") + ": it is of matches within a tolerance: give " +
                     option("max-steps") + ", or " + option("time-limit"));
  if (!is_tolerant() && gap)
    throw InputError(option("gap") + ": it is of matches within a tolerance: give " + option("max-steps") +
                     ", or " + option("time-limit"));
  return question_of_both(read_band);
}

std::string SolveTexts::given() const {
  std::string found = tolerances.empty() ? "" : option("tolerance");
  for_each_option(*this, [&found](const char *name, const OptionText &text) {
    if (text && found.empty())
      found = option(name);
  });
  return found;
}

std::string SolveTexts::idle_for_materials(const BudgetTexts &budget) const {
  for (const auto &[name, text] :
       {std::pair{"band", band}, std::pair{"pan-size", pan_size}, std::pair{"cut-below", cut_below}})
    if (text)
      return option(name);
  return budget.given();
}

AskedQuestion SolveTexts::question_of_both(const ReadBand &read_band) const {
  AskedQuestion asked = GradationTexts::question();
  Question &q = asked.rest;
  for (const std::string &text : tolerances)
    q.tolerances.push_back(named("tolerance", text, parse_tolerance));
  if (band)
    q.band = read_band(*band);
  if (min_per_class)
    q.min_per_class = natural("min-per-class", *min_per_class, 0);
  if (at_least)
    q.at_least = std::max(natural("at-least", *at_least, 0), Integer(1));
  if (specimen.has_value() != void_ratio.has_value())
    throw InputError(option("specimen") + " and " + option("void-ratio") + " belong together");
  if (specimen && solids_volume)
    throw InputError(option("specimen") + " and " + option("solids-volume") + ": give one of them");
  if (void_ratio)
    not_negative("void-ratio", *void_ratio);
  if (solids_volume)
    q.solids = SolidsVolume{positive("solids-volume", *solids_volume)};
  if (specimen)
    asked.specimen = AskedSpecimen{*specimen, *void_ratio};
  asked.in(SizeUnit::mm); // refuses a wrong specimen before a file is read
  return asked;
}

SolveOptions SolveTexts::options(bool keep_proof) const {
  SolveOptions o;
  o.limits.keep_proof = keep_proof;
  if (at_most)
    o.at_most = natural("at-most", *at_most, 0);
  if (digits)
    o.digits = digits_of("digits", *digits);
  if (scale)
    o.scale = scale_of(*scale);
  if (max_steps)
    o.limits.max_steps = natural64("max-steps", *max_steps);
  if (node_limit)
    o.limits.node_limit = natural64("node-limit", *node_limit);
  if (gap)
    o.limits.gap = not_negative("gap", *gap);
  if (time_limit)
    o.limits.deadline = std::chrono::steady_clock::now() + duration("time-limit", *time_limit);
  return o;
}

std::string BudgetTexts::given() const {
  for (const OptionRow<BudgetTexts> &row : options)
    if (this->*row.text())
      return option(row.name);
  return "";
}

void BudgetTexts::check() const {
  if (!particles && !given().empty())
    throw InputError(given() + ": it is of a budget: add " + option("particles") + ", or leave it out");
}

Budget BudgetTexts::budget(const SolveTexts &others) const {
  Budget budget;
  budget.particles = natural("particles", *particles, 1);
  if (grid)
    budget.grid = positive("grid", *grid);
  if (by && *by != "tolerance" && *by != "size-factor")
    throw InputError(option("by") + ": " + in_quotes(*by) + ": write tolerance or size-factor");
  if (by == "size-factor") {
    budget.by = BudgetBy::size_factor;
    check_factor_budget(others);
    return budget;
  }
  if (others.tolerances.size() > 1)
    throw InputError(option("particles") + ": it chooses one tolerance: give one " + option("tolerance") +
                     ", without a value");
  const std::string kind = kind_of(others);
  if (!names_kind(kind))
    throw InputError(option("tolerance") + ": " + in_quotes(kind) + ": " + option("particles") +
                     " chooses the value: write retained, passing or total");
  if (others.band || others.at_most)
    throw InputError(option(others.band ? "band" : "at-most") + ": it does not go with " +
                     option("particles") + ": leave it out");
  budget.kind = parse_tolerance(kind + ":0%").kind;
  return budget;
}

AskedQuestion BudgetTexts::question(const SolveTexts &others, const ReadBand &read_band) const {
  if (budget(others).by == BudgetBy::size_factor) // which refuses what it chooses
    return others.question(read_band);
  SolveTexts with_value = others;
  with_value.tolerances = {kind_of(others) + ":0%"};
  AskedQuestion asked = with_value.question(read_band);
  asked.rest.tolerances.clear();
  return asked;
}

} // namespace mdm
