#include "io/label_text.hpp"

#include <gtest/gtest.h>

namespace delone::io {
namespace {

TEST(PrintedUnits, RaiseExponents) {
  EXPECT_EQ(printed_units("m s-1"), "m s⁻¹");
  EXPECT_EQ(printed_units("mW m-2"), "mW m⁻²");
  EXPECT_EQ(printed_units("m^2"), "m²");
  EXPECT_EQ(printed_units("kg m**-3"), "kg m⁻³");
}

TEST(PrintedUnits, LeaveAloneWhatTheyDoNotUnderstand) {
  for (const char* units :
       {"", "m", "50 ft", "1e-6", "km/h", "m-", "^", "**", "a2b", "°C", "%"})
    EXPECT_EQ(printed_units(units), units);
}

TEST(PrintedUnits, KnowCelsiusAndNumbersWithoutUnits) {
  EXPECT_EQ(printed_units("degC"), "°C");
  EXPECT_EQ(printed_units("degree_Celsius"), "°C");
  EXPECT_EQ(printed_units("1"), "");
}

TEST(PrintedName, LosesTheUnitsAtItsEnd) {
  EXPECT_EQ(printed_name("sea_level_m", "m"), "sea level");
  EXPECT_EQ(printed_name("temp_c", "degC"), "temp");
  EXPECT_EQ(printed_name("heat_flow_mw_m2", "mW m-2"), "heat flow");
  EXPECT_EQ(printed_name("zinc_ppm", ""), "zinc ppm");
  EXPECT_EQ(printed_name("m", "m"), "m");
  EXPECT_EQ(printed_name("_m", "m"), " m");
}

TEST(Printable, KeepsUtf8) { EXPECT_EQ(printable("Höhe ≥ 0 🌍"), "Höhe ≥ 0 🌍"); }

TEST(Printable, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(printable("H\xf6he"), "H?he") << "Latin-1";
  EXPECT_EQ(printable("\xc3"), "?") << "cut short";
  EXPECT_EQ(printable("\xc0\x80"), "??") << "overlong";
  EXPECT_EQ(printable("\xe0\x80\x80"), "???") << "overlong";
  EXPECT_EQ(printable("\xed\xa0\x80"), "???") << "surrogate";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????") << "beyond 10ffff";
  EXPECT_EQ(printable("\xff"), "?");
}

TEST(Printable, MakesControlCharactersBlanks) {
  EXPECT_EQ(printable("a\nb\tc\x7f"), "a b c ");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a b");
}

TEST(FirstBytes, CutsNoCharacter) {
  EXPECT_EQ(first_bytes("6°N", 1), "6");
  EXPECT_EQ(first_bytes("6°N", 2), "6");
  EXPECT_EQ(first_bytes("6°N", 3), "6°");
  EXPECT_EQ(first_bytes("6°N", 100), "6°N");
  EXPECT_EQ(first_bytes("°", 1), "");
  EXPECT_EQ(first_bytes("", 0), "");
}

}  // namespace
}  // namespace delone::io
