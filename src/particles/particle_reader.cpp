#include "gradation/plain_words.hpp"
#include "particles/comment_words.hpp"
#include "particles/line_reader.hpp"
#include "particles/particle_columns.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Lines at the beginning that may tell nothing of the format, comments mostly.
constexpr std::size_t most_pending = 1000;
/// Bytes of such a line.
constexpr std::size_t longest_pending = 10000;

std::unique_ptr<LineReader> line_reader(ParticleFormat format, ParticleSource &source) {
  switch (format) {
  case ParticleFormat::csv:
    return read_particle_csv(source);
  case ParticleFormat::xyzr:
    return read_xyzr(source);
  case ParticleFormat::lammps_data:
    return read_lammps_data(source);
  case ParticleFormat::lammps_dump:
  case ParticleFormat::liggghts_dump:
    return read_dump(source);
  case ParticleFormat::vtk:
    return read_vtk(source);
  case ParticleFormat::diameters:
    return read_diameters(source);
  case ParticleFormat::liggghts_insertion:
    return read_liggghts_insertion(source);
  case ParticleFormat::mercurydpm:
    return read_mercurydpm(source);
  case ParticleFormat::extxyz:
    return read_extxyz(source);
  case ParticleFormat::esys:
    return read_esys(source);
  case ParticleFormat::lethe:
    return read_lethe(source);
  case ParticleFormat::kratos:
    return read_kratos(source);
  case ParticleFormat::dem_engine:
    return read_dem_engine(source);
  case ParticleFormat::musen:
    return read_musen(source);
  case ParticleFormat::phasicflow:
    return read_phasicflow(source);
  case ParticleFormat::vtp:
    return read_vtp(source);
  case ParticleFormat::answer:
    source.refuse("this is an answer of mdm, which is read as a whole: give the file itself");
  case ParticleFormat::gsd:
    break;
  }
  source.refuse("GSD is binary, which is read as a whole: give the file itself");
}

/// The fields of a line that may be a header of CSV; none where its quotes are wrong.
std::vector<std::string> csv_names(std::string_view line) {
  std::vector<std::string> names;
  const bool is_whole = split_fields(line, csv_delimiter(line), names);
  return is_whole ? names : std::vector<std::string>();
}

/// True for a header of CSV, also one that will be refused: names of columns, one of them of sizes or
/// quantities.
/// \param size_column  that was named
bool is_csv_header(std::string_view line, const std::optional<std::string> &size_column) {
  const std::vector<std::string> names = csv_names(line);
  if (size_column && std::find(names.begin(), names.end(), *size_column) != names.end())
    return true;
  const auto is_word = [](const std::string &name) { return name.find_first_of(" \t") == std::string::npos; };
  // ParaView has a column Point ID.
  return (std::all_of(names.begin(), names.end(), is_word) ||
          std::any_of(names.begin(), names.end(), is_of_paraview)) &&
         has_particle_column(names);
}

/// True for a line that begins extended XYZ, or a list of diameters.
bool is_count(std::string_view line) {
  return parse_count(trimmed(line)).has_value();
}

/// True for the first particle of a snapshot of ESyS-Particle, below its number: x y z r id tag mass ...
bool is_esys_particle(std::string_view line) {
  std::vector<std::string_view> words;
  split_words(line, words);
  constexpr std::size_t least = 7;
  return words.size() >= least && std::all_of(words.begin(), words.end(), is_number);
}

/// True for an object of MUSEN: 0 ID 1 TYPE 5 GEOMETRY 23 MATERIAL ...; by its material it is no x y z r.
bool is_musen_object(std::string_view line) {
  std::vector<std::string_view> words;
  split_words(line, words);
  constexpr std::size_t least = 7;
  return words.size() >= least && words[0] == "0" && words[2] == "1" && words[4] == "5" &&
         !std::all_of(words.begin(), words.end(), is_number);
}

/// True for a line of four words, x y z r.
bool is_place_and_radius(std::string_view line) {
  std::vector<std::string_view> words;
  split_words(line.substr(0, line.find('#')), words);
  constexpr std::size_t numbers = 4;
  return words.size() == numbers;
}

/// Refuses numbers below a line that names columns of sizes: they are no x y z r.
void refuse_spaced_table(const std::string &above, const ParticleSource &source) {
  const std::vector<std::string> words = words_behind_hash(above);
  const bool is_place = !words.empty() && words.front() == "x";
  if (!is_place && has_particle_column(words))
    source.refuse(
        "the line above names columns that spaces separate: write commas or tabs between them, and one "
        "table alone");
}

/// The unit in the heading that mdm export writes: `Particles of sand: 1485 in 7 classes, by exactmdm;
/// lengths in m, density ...`.
std::optional<SizeUnit> unit_of_heading(std::string_view line) {
  constexpr std::string_view before = ", by exactmdm; lengths in ";
  const std::size_t at = line.rfind(before);
  if (at == std::string_view::npos)
    return std::nullopt;
  const std::string_view rest = line.substr(at + before.size());
  return parse_size_unit(rest.substr(0, rest.find(',')));
}

/// Refuses files that are no text, by their first line.
void refuse_binary(std::string_view text, const ParticleSource &source) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    source.refuse("the file is in UTF-16: save it in UTF-8");
  if (text.find('\0') != std::string_view::npos)
    source.refuse(
        "the file is binary, which is not read: write it as text; of a restart file of LAMMPS or LIGGGHTS "
        "let them read_restart it and write a dump with id x y z radius");
}

[[noreturn]] void refuse_format(const ParticleSource &source) {
  source.refuse("the format is not one that is known: say it with " + option("from") + ", one of " +
                particle_format_names());
}

/// The format that the last of the lines at the beginning of a file tells; nothing where the next must be
/// looked at.
std::optional<ParticleFormat> format_of(const std::vector<std::string> &lines, const ParticleSource &source) {
  const std::string_view text = trimmed(lines.back());
  const bool is_first = lines.size() == 1;
  if (is_first && is_count(text))
    return std::nullopt;
  if (lines.size() == 2 && is_count(lines.front())) {
    if (text.find("Properties=") != std::string_view::npos)
      return ParticleFormat::extxyz;
    return is_esys_particle(text) ? ParticleFormat::esys : ParticleFormat::diameters;
  }
  if (is_first && text.starts_with("LSMGeometry"))
    return ParticleFormat::esys;
  if (text.starts_with("p_x;"))
    return ParticleFormat::lethe;
  if (text.starts_with("X,Y,Z,"))
    return ParticleFormat::dem_engine;
  if (is_musen_object(text))
    return ParticleFormat::musen;
  if (text.starts_with("Begin "))
    return ParticleFormat::kratos;
  if (text.starts_with("objectName particlesDict;"))
    return ParticleFormat::phasicflow;
  if (text.starts_with('<') && text.find("<VTKFile") != std::string_view::npos)
    return ParticleFormat::vtp;
  if (text.starts_with("//") || text.starts_with("<?xml") || text.starts_with("<!--"))
    return std::nullopt;
  if (is_first && text.starts_with("# vtk DataFile"))
    return ParticleFormat::vtk;
  if (text.empty() || text.front() == '#')
    return std::nullopt;
  if (text.front() == '{')
    return ParticleFormat::answer;
  if (text.starts_with("ITEM:"))
    return ParticleFormat::lammps_dump;
  if (text.starts_with("radius_") && text.find(",cumulative_number") != std::string_view::npos)
    return ParticleFormat::mercurydpm;
  if (is_csv_header(text, source.options().size_column))
    return ParticleFormat::csv;
  std::vector<std::string_view> words;
  split_words(text, words);
  std::vector<std::string_view> before_comment;
  split_words(text.substr(0, text.find('#')), before_comment);
  if (words.front() == "fix" || words.front() == "variable")
    return ParticleFormat::liggghts_insertion;
  if (before_comment.size() == 2 && before_comment[1] == "atoms" && !is_first)
    return ParticleFormat::lammps_data;
  const bool numbers = std::all_of(words.begin(), words.end(), is_number);
  if (numbers && words.size() == 1)
    return ParticleFormat::diameters;
  if (numbers && words.size() >= 4) {
    if (!is_first)
      refuse_spaced_table(lines[lines.size() - 2], source);
    return ParticleFormat::xyzr;
  }
  if (is_first && !numbers)
    return std::nullopt; // the title of a LAMMPS data file
  refuse_format(source);
}

/// True for a line that speaks of sieves or of what passes them.
bool speaks_of_gradation(const std::string &line) {
  const std::vector<std::string> words = words_of(line);
  return has_any_word("percent pct sieve sieves opening aperture retained passing finer cumulative siebweite "
                      "rueckstand durchgang tamis refus passant tamiz retenido pasa setaccio trattenuto",
                      words);
}

/// True where the first numbers of the lines rise or fall, and the fourth do, from or to 100, as sizes and
/// the percent that passes.
bool look_like_curve(std::string_view beginning) {
  std::vector<Rational> sizes, percents;
  for (std::size_t end = 0; (end = beginning.find('\n')) != std::string_view::npos;
       beginning.remove_prefix(end + 1)) {
    std::vector<std::string_view> words;
    split_words(beginning.substr(0, end), words);
    constexpr std::size_t numbers = 4;
    if (words.size() != numbers || !std::all_of(words.begin(), words.end(), is_number))
      continue;
    sizes.push_back(parse_decimal(words.front()));
    percents.push_back(parse_decimal(words.back()));
  }
  const auto is_sorted = [](const std::vector<Rational> &all) {
    return std::is_sorted(all.begin(), all.end()) || std::is_sorted(all.rbegin(), all.rend());
  };
  constexpr std::size_t enough = 3;
  return sizes.size() >= enough && is_sorted(sizes) && is_sorted(percents) &&
         std::max(percents.front(), percents.back()) == 100;
}

} // namespace

std::optional<ParticleFormat> told_format(std::string_view beginning) {
  class Nobody : public ParticleSink {
    void restart() override {}
    void add(const RootSize &, const Integer &) override {}
    void add(const SizeRange &, const Integer &) override {}
  } nobody;
  const ParticleSource source("", nobody, {});
  std::vector<std::string> lines;
  beginning = without_byte_order_mark(beginning);
  const std::string_view all = beginning;
  try {
    for (std::size_t end = 0; (end = beginning.find('\n')) != std::string_view::npos;
         beginning.remove_prefix(end + 1)) {
      lines.emplace_back(trimmed(beginning.substr(0, end)));
      const std::optional<ParticleFormat> format = format_of(lines, source);
      if (format == ParticleFormat::csv) {
        const std::vector<std::string> names = csv_names(lines.back());
        if (names.size() == 1 && find_size_column(names.front()) != nullptr)
          return std::nullopt; // a gradation without its masses, it may be
        particle_columns(names);
      }
      const bool may_be_table =
          format == ParticleFormat::xyzr && (!is_place_and_radius(lines.back()) || look_like_curve(all) ||
                                             std::any_of(lines.begin(), lines.end(), speaks_of_gradation));
      if (may_be_table)
        return std::nullopt; // of sieves, with a header or without
      if (format)
        return *format == ParticleFormat::answer ? std::nullopt : format;
    }
  } catch (const InputError &) {
    return std::nullopt;
  }
  return std::nullopt;
}

void ParticleSink::set_material(const std::string &name) {
  throw InputError(
      "material " + in_quotes(name) +
      ": particles with materials are for mdm verify with a gradation of several materials; here "
      "leave out the column material");
}

ParticleReader::ParticleReader(const std::string &file, ParticleSink &sink, const ParticleOptions &options)
    : source_(std::make_unique<ParticleSource>(file, sink, options)) {
  if (options.format)
    begin(*options.format);
}

ParticleReader::~ParticleReader() = default;

void ParticleReader::begin(ParticleFormat format) {
  format_ = format;
  const bool is_dump = format == ParticleFormat::lammps_dump || format == ParticleFormat::liggghts_dump;
  if (source_->options().timestep && !is_dump)
    source_->refuse(
        fmt::format("{} is for dumps, and this is {}: leave it out", option("timestep"), name(format)));
  const bool has_columns = is_dump || format == ParticleFormat::csv || format == ParticleFormat::vtk ||
                           format == ParticleFormat::vtp;
  if (source_->options().size_column && !has_columns)
    source_->refuse(fmt::format("{} is for dumps, CSV and VTK, and this is {}: leave it out",
                                option("size-column"), name(format)));
  if (source_->options().every_timestep && !is_dump)
    source_->refuse(fmt::format("{} is for dumps and GSD, and this is {}: leave it out", option("over-time"),
                                name(format)));
  reader_ = line_reader(format, *source_);
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    source_->set_line(i + 1);
    hand_on(pending_[i]);
  }
  pending_.clear();
}

void ParticleReader::hand_on(std::string_view text) {
  // Most formats have no unit of their own, and CSV has it in its header.
  constexpr std::uint64_t most_lines = 8;
  if (source_->line() <= most_lines && format_ != ParticleFormat::csv)
    if (const std::optional<SizeUnit> unit = unit_of_heading(text))
      source_->take_unit({name(*unit), in_mm(*unit)}, fmt::format("{} in its heading", name(*unit)));
  reader_->line(text);
}

void ParticleReader::line(std::string_view text) {
  source_->next_line();
  if (source_->line() == 1) {
    refuse_binary(text, *source_);
    text = without_byte_order_mark(text);
  }
  if (text.ends_with('\r'))
    text.remove_suffix(1);
  if (text.find('\r') != std::string_view::npos)
    source_->refuse(
        "a carriage return (CR) is there that no line feed (LF) follows: end lines with LF or CR LF");
  constexpr std::uint64_t last_line_of_title = 3;
  if (source_->line() <= last_line_of_title)
    source_->take_title(text);
  if (reader_) {
    hand_on(text);
    return;
  }
  pending_.emplace_back(text);
  const std::optional<ParticleFormat> found = format_of(pending_, *source_);
  if (!found && (pending_.size() == most_pending || text.size() > longest_pending))
    source_->refuse("the format is not clear by now: say it with " + option("from") + ", one of " +
                    particle_format_names());
  if (found)
    begin(*found);
}

void ParticleReader::end() {
  // A number alone is a diameter: extended XYZ has a second line.
  if (!reader_ && pending_.size() == 1 && is_count(pending_.front()))
    begin(ParticleFormat::diameters);
  const auto has_more = [](const std::string &line) {
    const std::string_view text = trimmed(line);
    return !text.empty() && text.front() != '#';
  };
  if (std::any_of(pending_.begin(), pending_.end(), has_more))
    refuse_format(*source_);
  if (!reader_)
    source_->refuse("there are no particles: the file ends before the first");
  reader_->end();
  source_->check_count();
}

std::optional<SizeUnit> ParticleReader::unit() const {
  return source_->unit();
}

std::vector<std::string> ParticleReader::notes() const {
  std::vector<std::string> notes = source_->notes();
  if (!source_->options().unit && format_ != ParticleFormat::csv && format_ != ParticleFormat::mercurydpm)
    notes.push_back(source_->size_note());
  return notes;
}

} // namespace mdm
