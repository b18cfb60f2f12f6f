#include "ask/describe_options.hpp"
#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_files.hpp"
#include "document/laboratory_report.hpp"
#include "document/report_texts.hpp"
#include "files/child_process.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_names.hpp"
#include "files/specification_file.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct ReportCommand {
  SampleFiles files;
  std::vector<std::string> fields;
  std::optional<std::string> spec, rounding, client, title, language, out, format;
  DescribeTexts asked;
  ReadingFlags reading;
  bool quiet = false;
};

enum class Form { html, pdf, json };

/// The one that was asked for, or as OUT ends; HTML on standard output. \throws InputError for another ending
Form form_of(const ReportCommand &c) {
  const std::string name = c.format ? "." + *c.format : c.out && *c.out != "-" ? *c.out : ".html";
  if (name.ends_with(".html") || name.ends_with(".htm"))
    return Form::html;
  if (name.ends_with(".pdf"))
    return Form::pdf;
  if (name.ends_with(".json"))
    return Form::json;
  throw InputError(fmt::format("-o: {}: let OUT end in .html, .pdf or .json, or give {}", printable(*c.out),
                               option("format")));
}

/// The head: the client, then what each --field says.
std::vector<std::pair<std::string, std::string>> head(const ReportCommand &c, const ReportTexts &texts) {
  std::vector<std::pair<std::string, std::string>> fields;
  if (c.client)
    fields.emplace_back(texts.client, *c.client);
  for (const std::string &field : c.fields) {
    const std::size_t equal = field.find('=');
    if (equal == std::string::npos || equal == 0)
      throw InputError(
          fmt::format("{}: {} is no NAME=VALUE: write Project=Harbour", option("field"), in_quotes(field)));
    fields.emplace_back(field.substr(0, equal), field.substr(equal + 1));
  }
  return fields;
}

LaboratoryReport reported(const ReportCommand &c) {
  const Language language = c.language == "de" ? Language::german : Language::english;
  const ReportTexts &texts = report_texts(language);
  LaboratoryReport r{c.title.value_or(std::string(texts.title)), head(c, texts), {}, std::nullopt, language};
  const DescribeOptions options = c.asked.describe_options();
  const std::optional<Rational> rounding = rounding_of(c.rounding);
  if (c.rounding && !c.spec)
    throw InputError(option("rounding") + " is about verdicts: give " + option("spec") + " too");
  if (c.spec)
    r.conformity = ConformityReport{specification_at(*c.spec), {}};
  ReadSamples read = c.files.read(c.reading, c.quiet);
  for (std::size_t i = 0; i < read.samples.size(); ++i) {
    UnderstoodGradation &sheet = read.samples[i];
    in_file(read.files[i], [&] {
      const Gradation g = c.asked.soil.with_pan(sheet.gradation);
      if (r.conformity)
        r.conformity->samples.push_back(judge(sheet, r.conformity->specification, rounding));
      r.samples.push_back({std::move(sheet), describe(g, options)});
    });
  }
  tell_apart(
      r.samples, [](ReportedSample &s) -> std::string & { return s.description.id; }, read.files);
  if (r.conformity)
    tell_apart(r.conformity->samples, &Conformity::id, read.files);
  return r;
}

/// The page as PDF, by the program weasyprint. \throws InputError where it is missing or fails
std::string printed(const std::string &html) {
  constexpr std::size_t most_bytes = std::size_t{256} << 20;
  const ChildEnd end = run_child("weasyprint --quiet - -", html, std::chrono::minutes(5), most_bytes);
  if (end.how == ChildEnd::How::exited && end.code == 127)
    throw InputError(
        "a PDF needs the program weasyprint: install it, or write OUT.html and let a browser print it");
  if (end.how != ChildEnd::How::exited || end.code != 0 || !end.output.starts_with("%PDF"))
    throw InputError(fmt::format("weasyprint made no PDF: {}: write OUT.html and let a browser print it",
                                 end.last_error.empty() ? "it says nothing" : printable(end.last_error)));
  return end.output;
}

std::string content(const LaboratoryReport &r, Form form) {
  constexpr unsigned digits = 15;
  return form == Form::json  ? report_json(r, digits) + "\n"
         : form == Form::pdf ? printed(report_html(r))
                             : report_html(r);
}

int run(const ReportCommand &c) {
  const Form form = form_of(c);
  if (form == Form::json && c.language)
    throw InputError(option("language") + " is about a page's own words, and JSON has none: leave it out");
  std::vector<std::string> inputs = c.files.paths;
  if (c.spec)
    inputs.push_back(*c.spec);
  check_paths(inputs, {c.out.value_or("-")});
  const LaboratoryReport r = reported(c);
  write_output(c.out.value_or("-"), content(r, form));
  if (std::any_of(r.samples.begin(), r.samples.end(),
                  [](const ReportedSample &s) { return s.description.limited(); }))
    return Exit::limited;
  return r.conformity ? exit_code(outcome_of(r.conformity->verdict())) : Exit::done;
}

} // namespace

Run add_report(CLI::App &app) {
  const auto c = std::make_shared<ReportCommand>();
  CLI::App &command = *app.add_subcommand(
      "report", "The laboratory's report of samples: curves, tables, index numbers, groups, verdicts");
  c->files.add_to(command, "SAMPLE");
  command.add_option("--spec", c->spec, specification_help())->type_name("FILE|NAME");
  command.add_option("--rounding", c->rounding, rounding_help())->type_name("UNIT");
  command.add_option("--title", c->title, "the title (Grain size report)");
  command
      .add_option(
          "--language", c->language,
          "language of the page's own words, numbers and notes: en (the default) or de; names, groups of "
          "ASTM and AASHTO, and a note that has no German text stay English")
      ->check(CLI::IsMember({"en", "de"}));
  command.add_option("--client", c->client, "the client, in the head of the report");
  command
      .add_option("--field", c->fields,
                  "another line of the head: --field Project=Harbour, any number of them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  add_options(command, DescribeTexts::options, c->asked);
  add_options(command, SoilTexts::options, c->asked.soil);
  command.add_option("--format", c->format, "html, pdf or json; else as OUT ends; html without OUT")
      ->check(CLI::IsMember({"html", "pdf", "json"}));
  command.add_option("-o", c->out, "write the report to OUT instead of standard output")->type_name("OUT");
  command.add_flag("--quiet", c->quiet, "no progress on standard error");
  c->reading.add_to(command);
  command.footer(
      footer(paragraph("The page of HTML is one file that needs no network, and prints on A4 and letter. It "
                       "has each sieve analysis, all curves on one chart beside the limits, what mdm "
                       "describe and mdm judge say, and every note that reading gave. A PDF is made of it by "
                       "the program weasyprint.") +
                 "\n" +
                 paragraph("Exit code 1: a sample does not keep the specification for every curve that "
                           "rounds to its report. 3: a limit of precision; the report says where."),
             {"mdm report sand.csv -o sand.html", "mdm report boreholes.xlsx --all-sheets -o r.html",
              "mdm report a.xlsx b.xlsx --spec astm-c33-fine --client \"Harbour Ltd\" -o r.html",
              "mdm report sand.csv --language de --spec en12620-0-4 -o bericht.html",
              "mdm report sand.csv --field Project=Quay --field \"Sampled=2026-05-04\" -o sand.pdf"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
