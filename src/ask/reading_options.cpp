#include "ask/reading_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

const std::vector<OptionRow<ReadingTexts>> ReadingTexts::options = {
    {"specimen-id", "ID",
     "the sample of a file with several: of AGS4 its LOCA_ID, SAMP_ID, SAMP_REF or all of them",
     &ReadingTexts::specimen_id},
    {"columns", "SIZE,VALUE", "the columns of sizes and masses: names, or numbers from 1 on",
     &ReadingTexts::columns},
    {"kind", "KIND", "what the values are: passing, retained, cumulative, or a name as in canonical CSV",
     &ReadingTexts::kind},
    {"unit", "UNIT", "what the sizes are: mm, um, m, in, phi or sieve", &ReadingTexts::unit},
    {"skip", "N", "leave out the first N lines or rows", &ReadingTexts::skip},
    {"sheet", "NAME", "the sheet of a workbook (the first)", &ReadingTexts::sheet},
    {"loss", "P%", "what the rows of a sheet may lack of its initial mass (1%)", &ReadingTexts::loss},
    {"round", "D", "take all masses to D significant digits before anything else", &ReadingTexts::round}};

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
