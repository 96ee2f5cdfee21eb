#include "common/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

namespace thalweg {
namespace {

std::string message_of(const char* text, const char* unit) {
  try {
    return "no error, but " + std::to_string(parse_quantity(text, unit));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(ParseQuantity, ConvertsToSi) {
  EXPECT_DOUBLE_EQ(parse_quantity("2 mm", "m"), 0.002);
  EXPECT_DOUBLE_EQ(parse_quantity("2mm", "m"), 0.002);
  EXPECT_DOUBLE_EQ(parse_quantity("  -1.5e1 cm ", "m"), -0.15);
  EXPECT_DOUBLE_EQ(parse_quantity("+3 m", "m"), 3);
  EXPECT_DOUBLE_EQ(parse_quantity("1540 kg/m^3", "kg/m^3"), 1540);
  EXPECT_DOUBLE_EQ(parse_quantity("1.54 g/cm3", "kg/m^3"), 1540);
  EXPECT_DOUBLE_EQ(parse_quantity("1540 kg m-3", "kg/m^3"), 1540);
  EXPECT_DOUBLE_EQ(parse_quantity("-9.81 m/s^2", "m/s^2"), -9.81);
  EXPECT_DOUBLE_EQ(parse_quantity("1 mPa s", "Pa s"), 1e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("1 min", "s"), 60);
  EXPECT_DOUBLE_EQ(parse_quantity("10 µm", "m"), 1e-5);
}

TEST(ParseQuantity, ReadsAnglesInDegreesAndRadians) {
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_quantity("180 degree", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_quantity("180°", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_quantity("0.5 rad", "rad"), 0.5);
}

// write_case relies on it: a value written in its SI unit comes back with the same bits.
TEST(ParseQuantity, KeepsValuesInSiUnitsExactly) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456.789}) {
    EXPECT_EQ(parse_quantity(std::to_string(1) + " m", "m"), 1.0);
    char text[64];
    std::snprintf(text, sizeof text, "%.17g m/s^2", value);
    EXPECT_EQ(parse_quantity(text, "m/s^2"), value);
  }
}

TEST(ParseQuantity, RefusesWhatIsNotAQuantity) {
  EXPECT_EQ(message_of("5", "m"), "\"5\" has no unit; add one, such as \"5 m\"");
  EXPECT_EQ(message_of("0", "m"), "\"0\" has no unit; add one, such as \"0 m\"");
  EXPECT_EQ(message_of("5 kg", "m"), "\"kg\" does not measure m; give it in m or a unit that converts to it");
  EXPECT_EQ(message_of("5 furlong_", "m"), "\"furlong_\" is not a unit; give it in m or a unit that converts to it");
  EXPECT_EQ(message_of("5 mm thick", "m"), "\"mm thick\" is not a unit; give it in m or a unit that converts to it");
  EXPECT_EQ(message_of("5 mm 3", "m"), "\"mm 3\" is not a unit; give it in m or a unit that converts to it");
  EXPECT_EQ(message_of("5 3 mm", "m"), "\"3 mm\" is not a unit; give it in m or a unit that converts to it");
  EXPECT_EQ(message_of("5 s since 2020-01-01", "s"),
            "\"s since 2020-01-01\" is not a unit; give it in s or a unit that converts to it");
  EXPECT_EQ(message_of("mm", "m"), "\"mm\" does not begin with a number; write a number and a unit, such as \"1 m\"");
  EXPECT_EQ(message_of("", "m"), "\"\" does not begin with a number; write a number and a unit, such as \"1 m\"");
  EXPECT_EQ(message_of("nan m", "m"), "\"nan m\" is not finite; write a finite number");
  EXPECT_EQ(message_of("-inf m", "m"), "\"-inf m\" is not finite; write a finite number");
  EXPECT_EQ(message_of("1e400 m", "m"), "\"1e400 m\" is too large or too small a number; check it");
  EXPECT_EQ(message_of("1e308 Mm", "m"), "\"1e308 Mm\" is not finite in m; check it");
}

TEST(ParseQuantity, MayBeCalledFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::vector<double> sums(4);
  for (double& sum : sums) {
    threads.emplace_back([&sum] {
      for (int i = 0; i < 200; ++i) sum += parse_quantity("1 mm", "m");
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_NEAR(sum, 0.2, 1e-12);
}

TEST(FormatQuantity, TakesTheUnitPeopleWrite) {
  EXPECT_EQ(format_quantity(0.005, "m"), "5 mm");
  EXPECT_EQ(format_quantity(-0.16, "m"), "-16 cm");
  EXPECT_EQ(format_quantity(1.5, "m"), "1.5 m");
  EXPECT_EQ(format_quantity(2500, "m"), "2500 m");
  EXPECT_EQ(format_quantity(1e-9, "m"), "0.001 um");
  EXPECT_EQ(format_quantity(0.00025, "s"), "250 us");
  EXPECT_EQ(format_quantity(90, "s"), "90 s");
  EXPECT_EQ(format_quantity(1234.5, "Pa"), "1.234 kPa");
  EXPECT_EQ(format_quantity(std::numbers::pi / 4, "rad"), "45 deg");
  EXPECT_EQ(format_quantity(0, "m"), "0 m");
  EXPECT_EQ(format_quantity(0, "rad"), "0 deg");
  EXPECT_EQ(format_quantity(1540, "kg/m^3"), "1540 kg/m^3");
}

}  // namespace
}  // namespace thalweg
