// Files of GSD: what mdm export writes, and files made here by hand from the description of the format.

#include "particles/gsd.hpp"
#include "replaced.hpp"
#include "support.hpp"

#include <cstring>

namespace gsd_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

template <class T>
std::string bytes(std::initializer_list<T> numbers) {
  std::string text;
  for (const T n : numbers) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &n, sizeof(T));
    text.append(raw.data(), raw.size());
  }
  return text;
}

/// A file of chunks: a header of 256 bytes, names, an index of 32 bytes an entry, numbers.
class File {
public:
  explicit File(std::uint32_t version = 2) : version_(version) {}

  template <class T>
  File &chunk(std::uint64_t frame, const std::string &name, std::uint8_t type, std::uint64_t rows,
              std::uint32_t columns, std::initializer_list<T> numbers) {
    const auto known =
        static_cast<std::size_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
    if (known == names_.size())
      names_.push_back(name);
    chunks_.push_back({frame, rows, columns, static_cast<std::uint16_t>(known), type, bytes(numbers)});
    return *this;
  }

  std::string text() const {
    std::string names;
    for (const std::string &name : names_) {
      names += name + '\0';
      if (version_ == 1)
        names.resize((names.size() + 63) / 64 * 64);
    }
    names.resize(64 * 16);
    const std::uint64_t index = 256 + names.size(), entries = chunks_.size() + 2;
    std::string head = bytes<std::uint64_t>({0x65DF65DF65DF65DF, index, entries, 256, 16}) +
                       bytes<std::uint32_t>({schema_version, version_ << 16U}) + std::string(64, '\0') +
                       schema;
    head.resize(256);
    head += names;
    std::string numbers;
    for (const Chunk &c : chunks_) {
      const std::uint64_t location = index + 32 * entries + numbers.size();
      head += bytes<std::uint64_t>({c.frame, c.rows, location}) + bytes<std::uint32_t>({c.columns}) +
              bytes<std::uint16_t>({c.name}) + bytes<std::uint8_t>({c.type, 0});
      numbers += c.numbers;
    }
    head.resize(index + 32 * entries);
    return head + numbers;
  }

  std::string schema = "hoomd";
  std::uint32_t schema_version = 0x10004;

private:
  struct Chunk {
    std::uint64_t frame, rows;
    std::uint32_t columns;
    std::uint16_t name;
    std::uint8_t type;
    std::string numbers;
  };
  std::uint32_t version_;
  std::vector<std::string> names_;
  std::vector<Chunk> chunks_;
};

constexpr std::uint8_t u32 = 3, u64 = 4, f32 = 9;

File two_grains(std::uint32_t version = 2) {
  return File(version)
      .chunk<std::uint64_t>(0, "configuration/step", u64, 1, 1, {10})
      .chunk<float>(0, "configuration/box", f32, 6, 1, {4, 4, 8, 0, 0, 0})
      .chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {2})
      .chunk<float>(0, "particles/diameter", f32, 2, 1, {0.5F, 0.1F})
      .chunk<float>(0, "particles/position", f32, 2, 3, {0, 0, -3, 1, 1, 1});
}

struct GsdResult {
  std::string particles;
  ReadParticles read;
};

GsdResult read_file_of(const std::string &text, const ParticleOptions &options = {}) {
  Recorder recorder;
  ReadParticles read = read_gsd(text, "file", recorder, options);
  return {recorder.text, std::move(read)};
}

std::string gsd_refusal(const std::string &text, const ParticleOptions &options = {}) {
  try {
    read_file_of(text, options);
  } catch (const InputError &error) {
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

} // namespace

TEST_CASE("GSD: diameters are the fractions that floats are, in m") {
  for (const std::uint32_t version : {1U, 2U}) {
    const std::string text = two_grains(version).text();
    CHECK(is_gsd(text));
    const GsdResult result = read_file_of(text);
    CHECK(result.particles == "500 100.000001490116119384765625"); // 0.1F = 13421773 / 2^27
    REQUIRE(result.read.notes.size() == 1);
    CHECK(result.read.notes.front() == "The sizes were taken as diameters in m.");
  }
}

TEST_CASE("GSD: types that are called by whole numbers are classes") {
  class ClassRecorder : public Recorder {
  public:
    std::string classes;
    void set_class(std::uint64_t number) override { classes += std::to_string(number) + " "; }
  };
  const auto classes = [](std::uint8_t type, std::uint32_t columns, std::initializer_list<char> names) {
    File file = two_grains();
    file.chunk<char>(0, "particles/types", type, columns == 0 ? 4 : names.size() / columns, columns, names)
        .chunk<std::uint32_t>(0, "particles/typeid", u32, 2, 1, {1, 0});
    ClassRecorder recorder;
    read_gsd(file.text(), "file", recorder, {});
    return recorder.classes;
  };
  constexpr std::uint8_t i8 = 5, u8 = 1;
  CHECK(classes(i8, 3, {'7', 0, 0, '1', '2', 0}) == "12 7 ");
  CHECK(classes(u8, 1, {'7', '8'}) == "8 7 ");
  CHECK(classes(i8, 2, {'A', 0, 'B', 0}).empty());
  CHECK(classes(i8, 1, {'7'}) == "7 "); // the second has no name
  CHECK(classes(i8, 0, {}).empty());
  CHECK(classes(f32, 1, {}).empty());
}

TEST_CASE("GSD: the last frame is read, or the one of a timestep; what it has not is of the first") {
  const std::string text = two_grains()
                               .chunk<std::uint64_t>(1, "configuration/step", u64, 1, 1, {20})
                               .chunk<float>(2, "particles/diameter", f32, 2, 1, {2, 1})
                               .text();
  CHECK(read_file_of(text).particles == "2000 1000");
  ParticleOptions options;
  options.timestep = 20;
  CHECK(read_file_of(text, options).particles == "500 100.000001490116119384765625");
  options.timestep = 30;
  CHECK(contains(gsd_refusal(text, options), "file: there is no timestep 30: the last is 10"));
  const std::string late =
      two_grains().chunk<std::uint64_t>(UINT64_MAX, "configuration/step", u64, 1, 1, {20}).text();
  CHECK(read_file_of(late).particles == "500 100.000001490116119384765625");
  CHECK(contains(gsd_refusal(late, options), "file: there is no timestep 30: the last is 20"));
}

TEST_CASE("GSD: every frame, one after the other") {
  class Steps : public Recorder {
  public:
    void restart() override {}
    void begin_timestep(const Integer &number) override { text += " @" + to_string(number); }
  } steps;
  ParticleOptions options;
  options.every_timestep = true;
  const std::string text = two_grains()
                               .chunk<std::uint64_t>(1, "configuration/step", u64, 1, 1, {20})
                               .chunk<float>(1, "particles/diameter", f32, 2, 1, {2, 1})
                               .text();
  read_gsd(text, "file", steps, options);
  CHECK(steps.text == " @10 500 100.000001490116119384765625 @20 2000 1000");
}

TEST_CASE("GSD: a damaged file is refused") {
  const std::string text = two_grains().text();
  for (std::size_t length = 0; length < text.size(); length += length < 1400 ? 16 : 1)
    CHECK(gsd_refusal(text.substr(0, length)).starts_with("file: "));
  CHECK(contains(gsd_refusal(text.substr(0, text.size() - 1)), "the file ends before what its index names"));
  CHECK(contains(gsd_refusal("size_mm,mass\n"), "it does not begin as GSD does"));
  CHECK(contains(gsd_refusal(File(3).chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {0}).text()),
                 "version 3 of the file layer is neither 1 nor 2"));
  CHECK(contains(gsd_refusal(File().text()), "there are no frames"));
  const auto with = [](const std::string &name, float size) {
    return File()
        .chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {1})
        .chunk<float>(0, name, f32, 1, 1, {size})
        .text();
  };
  CHECK(contains(gsd_refusal(with("particles/mass", 1)), "there are no particles/diameter"));
  CHECK(contains(gsd_refusal(with("particles/diameter", 0)), "file:1: diameter '0' is not above 0"));
  CHECK(contains(gsd_refusal(with("particles/diameter", -1)), "file:1: diameter '-1e+00' is not above 0"));
  CHECK(contains(gsd_refusal(with("particles/diameter", std::numeric_limits<float>::infinity())),
                 "file:1: a number is not finite"));
  CHECK(contains(gsd_refusal(File().chunk<std::uint64_t>(0, "particles/N", u64, 1, 1, {1}).text()),
                 "particles/N has 1 by 1 numbers of type 4, 1 by 1 of type 3 are expected"));
  CHECK(contains(gsd_refusal(File().chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {0}).text()),
                 "there are no particles"));
  CHECK(contains(gsd_refusal(File()
                                 .chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {UINT32_MAX})
                                 .chunk<float>(0, "particles/diameter", f32, UINT32_MAX, 1, {1})
                                 .text()),
                 "the file ends before what its index names"));
}

TEST_CASE("GSD: of a timestep that is there several times the last counts") {
  const std::string text = two_grains()
                               .chunk<std::uint64_t>(1, "configuration/step", u64, 1, 1, {20})
                               .chunk<float>(1, "particles/diameter", f32, 2, 1, {2, 1})
                               .chunk<std::uint64_t>(2, "configuration/step", u64, 1, 1, {20})
                               .chunk<float>(2, "particles/diameter", f32, 2, 1, {4, 1})
                               .chunk<std::uint64_t>(3, "configuration/step", u64, 1, 1, {30})
                               .text();
  ParticleOptions options;
  options.timestep = 20;
  CHECK(read_file_of(text, options).particles == "4000 1000");
}

TEST_CASE("GSD: another schema, and a chunk that a frame has twice, are refused") {
  File other = two_grains();
  other.schema = "custom";
  CHECK(contains(gsd_refusal(other.text()), "file: its schema is 'custom', and not hoomd"));
  File later = two_grains();
  later.schema_version = 0x20000;
  CHECK(contains(gsd_refusal(later.text()), "file: version 2 of schema hoomd is not 1"));
  CHECK(contains(gsd_refusal(two_grains().chunk<float>(0, "particles/diameter", f32, 2, 1, {2, 1}).text()),
                 "file: frame 0 has 'particles/diameter' twice"));
}

TEST_CASE("GSD is no text") {
  CHECK(contains(refusal("x\n", from(ParticleFormat::gsd)), "GSD is binary"));
}

TEST_CASE("GSD: a frame of no particles is refused, whatever chunks it has") {
  const std::string text = File()
                               .chunk<float>(0, "configuration/box", f32, 6, 1, {4, 4, 8, 0, 0, 0})
                               .chunk<std::uint32_t>(0, "particles/N", u32, 1, 1, {0})
                               .chunk<float>(0, "particles/diameter", f32, 0, 1, {})
                               .chunk<float>(0, "particles/position", f32, 0, 3, {})
                               .text();
  CHECK(contains(gsd_refusal(text), "there are no particles"));
}

} // namespace gsd_test
