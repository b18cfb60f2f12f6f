#include "cli/reading_flags.hpp"

#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"

namespace mdm::cli {

std::vector<CLI::Option *> ReadingFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "Reading the gradation");
  std::vector<CLI::Option *> added;
  const auto add = [&](const char *name, Text &value, const char *type, const char *help) {
    if (command.get_option_no_throw(name) == nullptr)
      added.push_back(command.add_option(name, value, help)->type_name(type));
  };
  add("--specimen-id", specimen_id, "ID",
      "the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them");
  add("--columns", columns, "SIZE,VALUE", "the columns of sizes and masses: names, or numbers from 1 on");
  add("--kind", kind, "KIND",
      "what the values are: passing, retained, cumulative, or a name as in canonical CSV");
  add("--unit", unit, "UNIT", "what the sizes are: mm, um, m, in, phi or sieve");
  add("--skip", skip, "N", "leave out the first N lines or rows");
  add("--sheet", sheet, "NAME", "the sheet of a workbook (the first)");
  add("--round", round, "D", "take all masses to D significant digits before anything else");
  return added;
}

std::string ReadingFlags::given() const {
  const std::string all = words();
  return all.empty() ? all : all.substr(1, all.find(' ', 1) - 1);
}

bool ReadingFlags::is_unit_at_most() const {
  ReadingFlags others = *this;
  others.unit.reset();
  return !others.is_given();
}

std::string ReadingFlags::words() const {
  std::string text;
  const auto add = [&text](const char *name, const Text &value) {
    if (value)
      text += std::string(" ") + name + " " + shell_word(*value);
  };
  add("--specimen-id", specimen_id);
  add("--columns", columns);
  add("--kind", kind);
  add("--unit", unit);
  add("--skip", skip);
  add("--sheet", sheet);
  add("--round", round);
  return text;
}

Reading ReadingFlags::reading(PhiReading phi) const {
  Reading r;
  r.specimen = specimen_id;
  r.phi = phi;
  r.columns = columns;
  r.kind = kind;
  r.unit = unit;
  r.sheet = sheet;
  if (skip)
    r.skip = natural64("--skip", *skip);
  if (round)
    r.round = digits_of("--round", *round);
  return r;
}

} // namespace mdm::cli
