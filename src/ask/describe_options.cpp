#include "ask/describe_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

const std::vector<OptionRow<DescribeTexts>> DescribeTexts::options = {
    {"d", "P,...", OptionKind::text,
     "more diameters D_P, the sizes that P percent of the mass pass: 5,16,84,90", &DescribeTexts::percents},
    {"void-ratio", "E", OptionKind::number,
     "also the hydraulic conductivity after Kozeny and Carman at this void ratio",
     &DescribeTexts::void_ratio}};

DescribeOptions DescribeTexts::describe_options() const {
  DescribeOptions o = soil.describe_options();
  if (percents) {
    o.percents = number_list("d", *percents);
    if (o.percents.back() > 100)
      throw InputError(option("d") + ": " + *percents +
                       " has more than 100 percent: give percents up to 100");
  }
  if (void_ratio)
    o.void_ratio = positive("void-ratio", *void_ratio);
  return o;
}

} // namespace mdm
