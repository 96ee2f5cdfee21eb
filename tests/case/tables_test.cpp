#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "case/reader/declare.hpp"
#include "case/reader/read_tables.hpp"
#include "case/reader/reference.hpp"
#include "case/reader/write_tables.hpp"
#include "case/tables/common_checks.hpp"
#include "common/error.hpp"

// A new table is one struct and one line in the list of tables: reader, writer, check, overrides, `thalweg explain`,
// the page and the schema follow. The proof is a case of three tables that the project does not know, one of each form,
// declared here alone.
namespace thalweg {
namespace {

using ::testing::HasSubstr;

struct Pond;

struct Basin {
  static constexpr TableHeading heading{"basin", "The water."};
  double depth = required;  // [m]

  template <class V>
  void describe(V& v) {
    v.quantity("depth", depth, "m", 0, 100, "From the surface to the ground.");
  }
};

enum class ProbeKind { thermometer, level };
inline constexpr std::array<Choice<ProbeKind>, 2> choices(ProbeKind) {
  return {
      {{ProbeKind::thermometer, "thermometer", "temperature at `depth`"}, {ProbeKind::level, "level", "at the bank"}}};
}

struct Probe {
  static constexpr TableHeading heading{"probe", "One for every probe.", "A probe is thin."};
  std::string name;
  ProbeKind kind = ProbeKind::level;
  double depth = 0;  // [m]

  template <class V>
  void describe(V& v) {
    v.text("name", name, "Name of the probe.");
    v.choice("kind", kind, "What it is.");
    v.quantity("depth", depth, "m", 0, 100, "thermometer: below the surface.");
  }
  [[nodiscard]] bool uses_key(std::string_view key, int) const {
    return key != "depth" || kind == ProbeKind::thermometer;
  }
  [[nodiscard]] std::vector<std::string> needs_keys(int) const {
    switch (kind) {
      case ProbeKind::thermometer:
        return {"depth"};
      case ProbeKind::level:
        return {};
    }
    return {};
  }
  void check(const Pond& whole, const CheckContext& at) const;
  static Probe without_defaults() { return {{}, ProbeKind::level, required}; }
};

struct Plant {
  static constexpr TableHeading heading{"plants.<plant>", "A plant, by its name."};
  double height = 1;  // [m]

  template <class V>
  void describe(V& v) {
    v.quantity("height", height, "m", 0, 10, "Above the ground.");
  }
};

struct Pond {
  Basin basin;
  std::vector<Probe> probes;
  std::map<std::string, Plant> plants;

  static constexpr auto tables() { return std::tuple{&Pond::basin, &Pond::probes, &Pond::plants}; }
  [[nodiscard]] static int dimension() { return 2; }
};

void Probe::check(const Pond& whole, const CheckContext& at) const {
  check_keys(at, *this);
  if (depth > whole.basin.depth) at.reject(at.key("depth"), at.path() + " lies in the ground", "raise it");
}

constexpr const char* pond_file = R"([basin]
depth = "2 m"

[[probe]]
name = "warm"
kind = "thermometer"
depth = "50 cm"

[[probe]]
name = "bank"

[plants.reed]
height = "1.5 m"
)";

const Declarations& declared() {
  static const Declarations tables = declare_tables<Pond>();
  return tables;
}

Pond read_pond(const std::string& text, const std::vector<std::string>& overrides = {}) {
  toml::table root = toml::parse(text, std::string("pond.toml"));
  for (const std::string& each : overrides) apply_override(root, each, declared());
  CaseOrigins origins;
  origins.file = "pond.toml";
  Pond pond;
  read_tables(root, declared(), ".", origins, pond);
  return pond;
}

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_pond(text, overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(NewTables, AreRead) {
  const Pond pond = read_pond(pond_file, {"plants.reed.height=3 m", "probe.warm.depth=1 m"});
  EXPECT_EQ(pond.basin.depth, 2);
  ASSERT_EQ(pond.probes.size(), 2U);
  EXPECT_EQ(pond.probes[0].kind, ProbeKind::thermometer);
  EXPECT_EQ(pond.probes[0].depth, 1);
  EXPECT_EQ(pond.plants.at("reed").height, 3);
}

TEST(NewTables, AreWrittenWithTheKeysThatMeanSomething) {
  const std::string expected = R"(
[basin]
depth = "2 m"

[[probe]]
name = 'warm'
kind = 'thermometer'
depth = "0.5 m"

[[probe]]
name = 'bank'
kind = 'level'

[plants.'reed']
height = "1.5 m"
)";
  std::ostringstream text;
  write_tables(text, read_pond(pond_file));
  EXPECT_EQ(text.str(), expected);
  std::ostringstream again;
  write_tables(again, read_pond(text.str()));
  EXPECT_EQ(again.str(), expected);
}

TEST(NewTables, AreChecked) {
  const std::string text = pond_file;
  EXPECT_EQ(message_of(text, {"basin.depth=10 cm"}), "pond.toml:7: probe.warm lies in the ground; raise it");
  EXPECT_EQ(message_of(text, {"probe.bank.kind=thermometer"}),
            "pond.toml:9: probe.bank.depth is missing; a probe of kind \"thermometer\" needs depth");
  EXPECT_EQ(message_of(text, {"probe.warm.kind=level"}),
            "pond.toml:7: probe.warm.depth means nothing for a probe of kind \"level\"; remove it");
}

TEST(NewTables, AreKnownByName) {
  const std::string text = pond_file;
  EXPECT_EQ(message_of(text + "hight = \"1 m\"\n"),
            "pond.toml:14: unknown key plants.reed.hight; did you mean plants.reed.height?");
  EXPECT_EQ(message_of("[brobe]\n" + text), "pond.toml:1: unknown table brobe; did you mean probe?");
  EXPECT_EQ(message_of("[zzzzzzzzzz]\n" + text),
            "pond.toml:1: unknown table zzzzzzzzzz; the tables are probe, plants, basin");
  EXPECT_EQ(message_of("[\"plants.reed\"]\n"), "pond.toml:1: unknown table plants.reed; did you mean plants?");
  EXPECT_EQ(message_of(text, {"probe.deep.depth=1 m"}),
            "--set probe.deep.depth=1 m: there is no probe \"deep\"; the probes are warm, bank");
  EXPECT_EQ(message_of(text, {"plants.lily.height=1 m"}),
            "--set plants.lily.height=1 m: there is no plant \"lily\"; the plants are reed");
}

TEST(NewTables, AreExplained) {
  std::ostringstream text;
  explain(text, "probe", declared());
  EXPECT_EQ(text.str(),
            "[[probe]]  One for every probe.\n\n"
            "probe.name\n  text; default \"\"\n  Name of the probe.\n"
            "probe.kind\n  word; default \"level\"\n  What it is.\n"
            "    \"thermometer\": temperature at `depth`\n    \"level\": at the bank\n"
            "probe.depth\n  m, 0 m to 100 m; required by some kinds\n  thermometer: below the surface.\n\n");
  std::ostringstream page;
  write_key_reference(page, declared());
  EXPECT_THAT(page.str(), HasSubstr("`probe.NAME.key`, `plants.NAME.key`"));
  EXPECT_THAT(page.str(), HasSubstr("## `[[probe]]`\n\nOne for every probe.\n\nA probe is thin.\n\n| key |"));
  EXPECT_THAT(page.str(), HasSubstr("## `[plants.<plant>]`"));
  std::ostringstream schema;
  write_key_schema(schema, declared());
  EXPECT_THAT(schema.str(), HasSubstr("\"plants\": {"));
  EXPECT_THAT(schema.str(), HasSubstr("\"required\": [\n    \"basin\"\n  ]"));
}

}  // namespace
}  // namespace thalweg
