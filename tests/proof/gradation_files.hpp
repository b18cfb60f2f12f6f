#pragma once
/// \file
/// Gradation files of all kinds, and random changes of them.

#include <random>
#include <string>
#include <vector>

namespace gradation_files {

inline const std::vector<std::string> seeds = {
    "size_mm,mass\n1,2\n2,1\n3,0\n",
    "# sand\nsize_mm,passing_percent\n2.40,100\n0.85,93.40\n0.43,81.35\n0.038,0\n",
    "\xef\xbb\xbfsize_um;cumulative_retained_percent\r\n2000;0\r\n1000,5;33\r\n80;99,5\r\npan;100\r\n",
    "sieve,passing_percent\n\"1/2\"\"\",100\n3/8 in,99\nNo. 4,97\n\"#200\",4.1\n",
    "# 4 sands\nsieve,mass\nNo. 4,0\n\"#10\",2\n# \u2027 8\nNo. 20,1\n",
    "sieve,retained_g,factor\n1.18 mm,0,1\nTyler 65 mesh,3.5,1.5\n75 um,2,2\npan,1,2.65\n",
    "size_phi,retained_fraction\n-1,0\n0.5,.25\n1.5,0.5\n4,2.5e-1\n",
    "size_in,mass,tolerance_percent\n0.375,0,1\n0.1,5,0.5\n0,3,2\n",
    "size_mm,passing_percent,tolerance_percent\n2,100,1\n1,40,0.5\n0.5,10,2\n",
    R"({"sizes": [3, 2, 1], "masses": [0, 1, 2], "tolerances_percent": [1, "2", 3.5]})",
    R"({"id": "g1", "unit": "mm", "sizes": ["0.075", 0.15, "3e-1"], "masses": [1, 2.50, "0"]})",
    R"({"sizes": [3, 2, 1], "masses": [0, 1, 2], "factors": [1, "2", 3.5], "\u0069d": "\u00e9 \ud83d\ude00"})",
};

/// A few random changes, mostly with characters that mean something.
inline std::string mutated(std::string text, std::mt19937_64 &random) {
  static const std::string characters = "0123456789.,;\"#-+eE \t\r\n{}[]:nullpanminNo/\\u\xc2\xb5\xef\x80";
  for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
    const std::size_t at = random() % (text.size() + 1);
    const char c = characters[random() % characters.size()];
    switch (random() % 5) {
    case 0:
      text.insert(at, 1, c);
      break;
    case 1:
      text.erase(at, 1 + random() % 3);
      break;
    case 2:
      text.insert(at, text.substr(random() % (text.size() + 1), random() % 20));
      break;
    default:
      if (at < text.size())
        text[at] = c;
    }
  }
  return text;
}

} // namespace gradation_files
