#include "soil/texture_diagram.hpp"

namespace mdm {
namespace {

/// Where gravel and the rest divide the base of mud and sand as the share `sand` does.
TexturePlace folk_place(double gravel, double sand) {
  return {(100 - gravel) * (1 - sand), (100 - gravel) * sand, gravel};
}

constexpr double trace = 0.01, few = 5, some = 30, most = 80; // percent of gravel

TextureDiagram folk_diagram() {
  TextureDiagram d{{"mud", "sand", "gravel"}, {}, {}};
  for (const double gravel : {trace, few, some, most})
    d.lines.push_back({folk_place(gravel, 0), folk_place(gravel, 1)});
  d.lines.push_back({folk_place(0, 0.1), folk_place(few, 0.1)});
  for (const double sand : {0.5, 0.9})
    d.lines.push_back({folk_place(0, sand), folk_place(most, sand)});
  d.fields = {{"gravel", "gravel", folk_place(87, 0.5)},
              {"muddy gravel", "mG", folk_place(50, 0.25)},
              {"muddy sandy gravel", "msG", folk_place(50, 0.7)},
              {"sandy gravel", "sG", folk_place(50, 0.95)},
              {"gravelly mud", "gM", folk_place(17, 0.25)},
              {"gravelly muddy sand", "gmS", folk_place(17, 0.7)},
              {"gravelly sand", "gS", folk_place(17, 0.95)},
              {"slightly gravelly mud", "(g)M", folk_place(2.5, 0.05)},
              {"slightly gravelly sandy mud", "(g)sM", folk_place(2.5, 0.3)},
              {"slightly gravelly muddy sand", "(g)mS", folk_place(2.5, 0.7)},
              {"slightly gravelly sand", "(g)S", folk_place(2.5, 0.95)},
              {"mud", "M", folk_place(0, 0.05)},
              {"sandy mud", "sM", folk_place(0, 0.3)},
              {"muddy sand", "mS", folk_place(0, 0.7)},
              {"sand", "S", folk_place(0, 0.95)}};
  return d;
}

TextureDiagram shepard_diagram() {
  return {{"sand", "silt", "clay"},
          {{{{75, 25, 0}, {75, 0, 25}}},
           {{{25, 75, 0}, {0, 75, 25}}},
           {{{25, 0, 75}, {0, 25, 75}}},
           {{{60, 20, 20}, {20, 60, 20}}},
           {{{60, 20, 20}, {20, 20, 60}}},
           {{{20, 60, 20}, {20, 20, 60}}},
           {{{50, 50, 0}, {40, 40, 20}}},
           {{{50, 0, 50}, {40, 20, 40}}},
           {{{0, 50, 50}, {20, 40, 40}}},
           {{{75, 12.5, 12.5}, {60, 20, 20}}},
           {{{12.5, 75, 12.5}, {20, 60, 20}}},
           {{{12.5, 12.5, 75}, {20, 20, 60}}}},
          {{"sand", "sand", {84, 8, 8}},
           {"silt", "silt", {8, 84, 8}},
           {"clay", "clay", {9, 9, 82}},
           {"silty sand", "silty sand", {58, 33, 9}},
           {"sandy silt", "sandy silt", {33, 58, 9}},
           {"clayey sand", "clayey sand", {59, 9, 32}},
           {"sandy clay", "sandy clay", {33, 9, 58}},
           {"clayey silt", "clayey silt", {9, 59, 32}},
           {"silty clay", "silty clay", {9, 33, 58}},
           {"sand-silt-clay", "sand-silt-clay", {35, 35, 30}}}};
}

TextureDiagram usda_diagram() {
  return {{"sand", "silt", "clay"},
          {{{{85, 15, 0}, {90, 0, 10}}},
           {{{70, 30, 0}, {85, 0, 15}}},
           {{{80, 0, 20}, {52, 28, 20}}},
           {{{52, 28, 20}, {45, 28, 27}}},
           {{{45, 28, 27}, {45, 0, 55}}},
           {{{65, 0, 35}, {45, 20, 35}}},
           {{{45, 28, 27}, {0, 73, 27}}},
           {{{45, 15, 40}, {0, 60, 40}}},
           {{{20, 53, 27}, {20, 40, 40}}},
           {{{20, 40, 40}, {0, 40, 60}}},
           {{{20, 80, 0}, {8, 80, 12}}},
           {{{8, 80, 12}, {0, 88, 12}}},
           {{{50, 50, 0}, {23, 50, 27}}},
           {{{43, 50, 7}, {52, 41, 7}}},
           {{{52, 41, 7}, {52, 28, 20}}}},
          {{"sand", "sand", {92, 5, 3}},
           {"loamy sand", "loamy sand", {79.3, 17.5, 3.2}},
           {"sandy loam", "sandy loam", {65, 25, 10}},
           {"loam", "loam", {42, 40, 18}},
           {"silt loam", "silt loam", {20, 65, 15}},
           {"silt", "silt", {7, 87, 6}},
           {"sandy clay loam", "sandy clay loam", {60, 13, 27}},
           {"clay loam", "clay loam", {33, 34, 33}},
           {"silty clay loam", "silty clay loam", {10, 57, 33}},
           {"sandy clay", "sandy clay", {53.5, 8.5, 38}},
           {"silty clay", "silty clay", {7.5, 47.5, 45}},
           {"clay", "clay", {22, 18, 60}}}};
}

} // namespace

const TextureDiagram &texture_diagram(TextureSystem system) {
  static const TextureDiagram folk = folk_diagram(), shepard = shepard_diagram(), usda = usda_diagram();
  return system == TextureSystem::folk ? folk : system == TextureSystem::shepard ? shepard : usda;
}

} // namespace mdm
