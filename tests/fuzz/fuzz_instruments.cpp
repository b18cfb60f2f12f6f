/// \file
/// libFuzzer target: the files of instruments. The input is what follows their headers.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  for (const std::string head : {"Size class [mm]\tp3 [%]\tQ3 [%]\n", "[#Bindiam]\n0.4\n0.5\n[#Binheight]\n",
                                 "Sample Name,Result Between User Sizes (Sizes in um),,\n,1,10,100\n",
                                 "Sample Name;Result Under User Sizes (Sizes in um);;\n"})
    mdm::fuzz::check_reader([&] { return mdm::read_gradation(head + content, "fuzz.txt"); });
  return 0;
}
