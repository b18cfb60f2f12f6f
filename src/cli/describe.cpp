#include "ask/describe_options.hpp"
#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/describe_shares.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_files.hpp"
#include "cli/solve_number.hpp"
#include "cli/whole_number.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/sample_names.hpp"
#include "files/standard_streams.hpp"
#include "report/description.hpp"
#include "report/sample_notes.hpp"
#include "report/sediment_report.hpp"
#include "text/option_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct DescribeCommand {
  SampleFiles files;
  DescribeTexts asked;
  bool sediment = false, by_number = false;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  OutputFlags output;
};

/// The forms of a report of one sample, and of a table of several.
template <class Description>
struct Forms {
  std::string (&text)(const Description &, unsigned);
  std::string (&json)(const Description &, unsigned);
  std::string (&csv)(const Description &, unsigned);
  std::string (&table_text)(const std::vector<Description> &, unsigned);
  std::string (&table_csv)(const std::vector<Description> &, unsigned);
};

/// The report in the form that was asked for: of several samples a table, or a line of JSON each.
template <class Description>
std::string report(const DescribeCommand &c, const std::vector<Description> &all,
                   const Forms<Description> &forms) {
  const unsigned exchanged = c.digits.value_or(15), read = c.digits.value_or(4);
  const auto json = [&] {
    std::string lines;
    for (const Description &d : all)
      lines += (lines.empty() ? "" : "\n") + forms.json(d, exchanged);
    return lines;
  };
  if (all.size() == 1)
    return c.output.report([&] { return forms.text(all[0], read); }, json,
                           [&] { return forms.csv(all[0], exchanged); });
  return c.output.report([&] { return forms.table_text(all, read); }, json,
                         [&] { return forms.table_csv(all, exchanged); });
}

/// Describes all samples, writes the report and says whether a limit of precision was reached.
template <class Description, class Describe>
bool describe_all(const DescribeCommand &c, const Forms<Description> &forms, Describe describe) {
  std::vector<Description> all;
  const ReadSamples read = c.files.read(c.reading, c.output.quiet);
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    all.push_back(
        in_file(read.files[i], [&] { return describe(c.asked.soil.with_pan(read.samples[i].gradation)); }));
  tell_apart(all, &Description::id, read.files);
  write_output(c.output.path(), report(c, all, forms));
  if (all.size() > 1)
    c.output.tell_notes_beside_csv(notes_of_samples(all));
  return std::any_of(all.begin(), all.end(), [](const Description &d) { return d.limited(); });
}

bool describe_sediments(const DescribeCommand &c) {
  const SoilTexts &soil = c.asked.soil;
  if (soil.liquid_limit || soil.plastic_limit || c.asked.percents || c.asked.void_ratio)
    throw InputError(fmt::format("{} has no use for {}, {} and Atterberg limits: leave them out",
                                 option("sediment"), option("d"), option("void-ratio")));
  return describe_all<SedimentDescription>(
      c, {sediment_text, sediment_json, sediment_csv, sediments_text, sediments_csv},
      [&](const Gradation &g) { return describe_sediment(g, soil.extrapolate); });
}

bool describe_soils(const DescribeCommand &c) {
  const DescribeOptions options = c.asked.describe_options();
  return describe_all<SoilDescription>(
      c, {description_text, description_json, description_csv, descriptions_text, descriptions_csv},
      [&](const Gradation &g) { return describe(g, options); });
}

/// Refuses what has no use beside the shares by number.
void check_for_shares(const DescribeCommand &c, const std::string &what) {
  const DescribeTexts &d = c.asked;
  if (c.files.paths.size() > 1 || c.files.all_sheets)
    throw InputError(what + " is of one file at a time: describe each by itself");
  if (c.sediment || d.percents || d.void_ratio || d.soil.liquid_limit || d.soil.plastic_limit ||
      d.soil.extrapolate)
    throw InputError(fmt::format("{} has no use for {}, {}, {}, {} and Atterberg limits: leave them out",
                                 what, option("sediment"), option("d"), option("void-ratio"),
                                 option("extrapolate")));
}

void describe_by_number(const DescribeCommand &c) {
  check_for_shares(c, option("by-number"));
  const std::string &path = c.files.paths.front();
  const UnderstoodGradation read = any_curve(path, c.reading, c.output.quiet);
  describe_shares(
      in_file(path, [&] { return class_shares(c.asked.soil.with_pan(read.gradation), ShareOf::mass); }),
      c.output, c.digits);
}

/// A file of shares by number has those of the mass told, and nothing else.
void describe_numbers(const DescribeCommand &c, const std::string &path) {
  check_for_shares(c, "a gradation by number");
  const std::string given = c.by_number             ? option("by-number")
                            : c.asked.soil.pan_size ? option("pan-size")
                                                    : c.reading.given();
  if (!given.empty())
    refuse_beside_numbers(given, path);
  describe_shares(shares_of_mass(path), c.output, c.digits);
}

int run(const DescribeCommand &c) {
  check_paths(c.files.paths, {c.output.path()});
  const auto numbers = std::find_if(c.files.paths.begin(), c.files.paths.end(), is_number_file);
  if (numbers != c.files.paths.end()) {
    describe_numbers(c, *numbers);
    return Exit::done;
  }
  if (c.by_number) {
    describe_by_number(c);
    return Exit::done;
  }
  const bool limited = c.sediment ? describe_sediments(c) : describe_soils(c);
  return limited ? Exit::limited : Exit::done;
}

} // namespace

Run add_describe(CLI::App &app) {
  const auto c = std::make_shared<DescribeCommand>();
  CLI::App &command =
      *app.add_subcommand("describe", "Index numbers, fractions and the soil groups of gradations");
  c->files.add_to(command, "FILE", "; of several there is a table with a line each");
  add_options(command, DescribeTexts::options, c->asked);
  add_options(command, SoilTexts::options, c->asked.soil);
  command.add_flag("--sediment", c->sediment,
                   "as sedimentology has it: Folk and Ward, moments, Trask, modes, texture, Wentworth");
  command.add_flag("--by-number", c->by_number,
                   "the shares of the number of particles that the classes have, as ranges");
  command.add_option("--digits", c->digits, "significant digits (15; in the text form 4)")
      ->type_name("D")
      ->transform(whole_number(1, 1000));
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "C_u = D60 / D10 and C_c = D30^2 / (D10 D60) are of ASTM D2487. I_GS is the grain size index of "
          "Erguler (2016), I_C Arnold's index of curvature, phi_1 the mass of the finest class over that of "
          "the coarsest, zeta_1 the volume of the coarsest class's largest particle over that of the "
          "finest's (Arnold, Eq. 15 and 16). The span is (D90 - D10) / D50. D[3,2] and D[4,3] are the means "
          "over "
          "surface and volume of ISO 9276-2, between their values with all particles at the lower and at the "
          "upper sieves of their classes. FM and FM EN are the fineness moduli of ASTM C125 and EN 12620, "
          "with "
          "shares and not percents added.") +
          "\n" +
          paragraph(
              "Groups are of ASTM D2487 and of AASHTO M 145, which rounds percents and limits to whole "
              "numbers, halves to the even one; its group index stands in brackets. ISO is the name in the "
              "diagram of ISO 14688-2:2004, Annex B: what is at a limit is above it, and of equal "
              "shares the coarser is the greater. k_H is the "
              "hydraulic conductivity after Hazen, 0.01 m/s "
              "times the "
              "square of D10 in mm; k_KC, with --void-ratio, that of Kozeny and Carman after Carrier "
              "(2003).") +
          "\n" +
          paragraph(
              "--by-number: of spheres of one density, whatever their sizes in the classes. Of a file of "
              "shares by number (number_percent, cumulative_number_percent) the shares of the mass are "
              "told.") +
          "\n" +
          paragraph(
              "--sediment: mean, sorting, skewness and kurtosis on the phi scale, after Folk and Ward (1957) "
              "and as moments of the classes' middles, with their words, decided at their limits; the "
              "texture "
              "is of Folk (1954).") +
          "\n" +
          paragraph("Exit code 3: a group or name hangs on an interpolated share or an index that 1,200 "
                    "digits do not "
                    "tell from its limit; the report says which."),
      {"mdm describe sand.csv", "mdm describe sand.csv --sediment", "mdm describe sand.csv --by-number",
       "mdm describe sand.csv --d 5,16,84,95",
       "mdm describe bh1.csv bh2.csv bh3.csv --format csv -o table.csv",
       "mdm describe boreholes.xlsx --all-sheets",
       "mdm describe sand.csv --liquid-limit 30 --plastic-limit 22",
       "mdm describe report.ags --specimen-id BH1 --format json -o bh1.json"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
