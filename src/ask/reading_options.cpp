#include "ask/reading_options.hpp"

#include "ask/option_values.hpp"
#include "text/file_names.hpp"

#include <algorithm>

namespace mdm {

const std::vector<OptionRow<ReadingTexts>> ReadingTexts::options = {
    {"specimen-id", "ID", OptionKind::text,
     "the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them",
     &ReadingTexts::specimen_id},
    {"columns", "SIZE,VALUE", OptionKind::text,
     "the columns of sizes and masses: names, or numbers from 1 on", &ReadingTexts::columns},
    {"kind", "KIND", OptionKind::text,
     "what the values are: passing, retained, cumulative, or a name as in canonical CSV",
     &ReadingTexts::kind},
    {"unit", "UNIT", OptionKind::text, "what the sizes are: mm, um, m, in, phi or sieve",
     &ReadingTexts::unit},
    {"skip", "N", OptionKind::number, "leave out the first N lines or rows", &ReadingTexts::skip},
    {"sheet", "NAME", OptionKind::text, "the sheet of a workbook (the first)", &ReadingTexts::sheet},
    {"loss", "P%", OptionKind::number, "what the rows of a sheet may lack of its initial mass (1%)",
     &ReadingTexts::loss},
    {"round", "D", OptionKind::number,
     "take all masses, or the values of a column that passes or is cumulative, to D significant digits "
     "before anything else",
     &ReadingTexts::round}};

std::string ReadingTexts::given() const {
  const auto found = std::find_if(options.begin(), options.end(), [this](const OptionRow<ReadingTexts> &row) {
    return (this->*row.text()).has_value();
  });
  return found == options.end() ? "" : option(found->name);
}

bool ReadingTexts::is_unit_at_most() const {
  ReadingTexts others = *this;
  others.unit.reset();
  return !others.is_given();
}

std::string ReadingTexts::words() const {
  std::string text;
  for (const OptionRow<ReadingTexts> &row : options)
    if (const OptionText &value = this->*row.text())
      text += std::string(" --") + row.name + " " + shell_word(*value);
  return text;
}

Reading ReadingTexts::reading(PhiReading phi) const {
  Reading r;
  r.specimen = specimen_id;
  r.phi = phi;
  r.columns = columns;
  r.kind = kind;
  r.unit = unit;
  r.sheet = sheet;
  if (skip)
    r.skip = natural64("skip", *skip);
  if (loss)
    r.loss = percent_of("loss", *loss);
  if (round)
    r.round = digits_of("round", *round);
  return r;
}

} // namespace mdm
