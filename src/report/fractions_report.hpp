#pragma once
/// \file
/// Numbers and fractions of the mass of a gradation, as the descriptions have them.

#include "answer/json_values.hpp"
#include "soil/fractions.hpp"
#include "text/text_buffer.hpp"

#include <vector>

namespace mdm {

/// An enclosure, or null for what is not available.
void write_value(JsonWriter &json, const std::optional<Real> &value, unsigned digits);

/// [{name, above, up_to, percent}]
void write_fractions(JsonWriter &json, const std::vector<Fraction> &fractions, unsigned digits);

/// item,unit,lo,hi,text
void add_csv_row(TextBuffer &out, const std::string &item, const char *unit, const std::optional<Real> &value,
                 unsigned digits, const std::string &text = "");
/// A row a fraction, `SYSTEM NAME`.
void add_csv_fractions(TextBuffer &out, const char *system, const std::vector<Fraction> &fractions,
                       unsigned digits);

/// `,lo,hi`, empty for what is not available.
void add_csv_bounds(TextBuffer &out, const std::optional<Real> &value, unsigned digits);
/// `coarse_sand` of `coarse sand`.
std::string column_name(std::string_view fraction);
/// The share in percent, where it is available.
std::optional<Real> percent(const Fraction &f);

/// A line a band; parts without a value, parts of empty bands, and empty bands coarser than all are left out.
void add_text_fractions(TextBuffer &out, const char *system, const std::vector<Fraction> &fractions,
                        unsigned digits);

} // namespace mdm
