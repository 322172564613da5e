#include <catch2/catch.hpp>
#include <string>

#include "wrong_case.hpp"

namespace {

using rgimp::testing::kRightCase;
using rgimp::testing::message_of;
using rgimp::testing::with;

std::string repeat(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) {
    all += text;
  }
  return all;
}

}  // namespace

TEST_CASE("empty values, wrong lengths, words and keys given twice") {
  rgimp::testing::check_rows({
      {"[20e-3, 40e-3]", "[]", "8: body[0].size: has 0 components; expected 2"},
      {"[20e-3, 40e-3]", "[20e-3]", "8: body[0].size: has 1 components; expected 2"},
      {"[20e-3, 40e-3]", "[[20e-3, 40e-3]]", "8: body[0].size: has 1 components; expected 2"},
      {"[20e-3, 40e-3]", "{}",
       "8: body[0].size: found a table; expected an array of 2 real numbers"},
      {"center = [0.0, 0.0]\nsize", "center = [0.0, true]\nsize",
       "7: body[0].center[1]: found a boolean; expected a real number"},
      {"shape = \"box\"", "shape = \"\"", "6: body[0].shape: \"\" is not one of box, disk"},
      {"material = \"rock\"", "material = \"\"",
       "9: body[0].material: no material \"\"; the materials are rock"},
      {"side = \"top\"", "side = \"Top\"",
       "26: platen[0].side: \"Top\" is not one of top, bottom, left, right; did you mean \"top\"?"},
      {"side = \"top\"", "side = \" top\"",
       "26: platen[0].side: \" top\" is not one of top, bottom, left, right; did you mean "
       "\"top\"?"},
      {"shape = \"box\"", "shape = [\"box\"]",
       "6: body[0].shape: found an array; expected a string"},
      {"dimension = 2", "dimension = 2\ndimension = 2",
       "3: Error while parsing key-value pair: cannot redefine existing integer 'dimension'"},
      {"cell_size = 0.5e-3", "cell_size = 0.5e-3\ncell_size = 0.5e-3",
       "5: Error while parsing key-value pair: cannot redefine existing floating-point "
       "'cell_size'"},
      {"[time]", "[grid]\n[time]",
       "31: Error while parsing table header: cannot redefine existing table 'grid'"},
      {"[material.rock.failure]", "[material.rock]\n[material.rock.failure]",
       "20: Error while parsing table header: cannot redefine existing table 'material.rock'"},
      {"[[body]]", "[[\"\"]]",
       "1: : unknown key; the keys here are title, dimension, grid, body, flaw, material, platen, "
       "time, damping, viscosity, body_force, output, numerics, tuning"},
      {"density", "dénsité", "17: Error while parsing key-value pair: expected '=', saw 'é'"},
      {"[grid]", "[größe]", "3: Error while parsing table header: expected ']', saw 'ö'"},
      {"density = 2600.0", "\"\" = 1",
       "17: material.rock.: unknown key; the keys here are density, youngs_modulus, poisson_ratio, "
       "failure"},
      {"dimension = 2", "dimension = 0b11", "7: body[0].center: has 2 components; expected 3"},
      {"dimension = 2", "dimension = 2_",
       "2: Error while parsing key-value pair: expected a comment or whitespace, saw '_'"},
      {"0.5e-3", ".5e-3", "4: Error while parsing floating-point: expected decimal digit, saw '.'"},
      {"0.5e-3", "0.5e-3m",
       "4: Error while parsing floating-point: expected decimal digit, saw 'm'"},
      {"0.5e-3", "0,5e-3",
       "4: Error while parsing key-value pair: expected a comment or whitespace, saw ','"},
      {"0.5e-3", "+inf", "4: grid.cell_size: is inf; expected a finite number"},
      {"[[platen]]\nside = \"top\"\nspeed = 0.005\n[[platen]]\nside = \"bottom\"\nspeed = 0.005",
       "platen = [1, 2]",
       "25: material.rock.failure.platen: unknown key; the keys here are criterion, treatment, "
       "cohesion, friction_angle, tensile_strength, shear_strength, tensile_strain, shear_strain, "
       "fracture_energy, shear_fracture_energy, pressure_min, pressure_max"},
      {"[time]\nsteps = 1000\n", "time = []\n",
       "31: platen[1].time: unknown key; the keys here are side, speed, ramp, lateral, half_width"},
      {"[material.rock]", "[material]\nrock = 3\n[x]",
       "23: Error while parsing table header: cannot redefine existing integer "
       "'material.rock.failure' as table"},
      {"[time]", "[body]\n[time]",
       "31: Error while parsing table header: cannot redefine existing array 'body' as table"},
  });
}

TEST_CASE("bytes that are no text") {
  const std::string not_utf8 = "Encountered invalid utf-8 sequence";
  const std::string control =
      "1: Error while parsing string: unescaped control characters other than TAB (U+0009) are "
      "explicitly prohibited";
  const std::string scalar = "1: Error while parsing unicode scalar sequence: ";
  CHECK(message_of("\xef\xbb\xbf" + kRightCase) == "accepted");
  CHECK(message_of("\xef\xbb\xbf") == "1: grid: missing; expected a table");
  CHECK(message_of(" \n\n") == "1: grid: missing; expected a table");
  CHECK(message_of(std::string("\xff\xfet\0", 4) + kRightCase) == "1: " + not_utf8);
  CHECK(message_of(with("small",
                        "sm\xff"
                        "all")) == "1: " + not_utf8);
  CHECK(message_of(with("small", "\xc0\xaf")) == "1: " + not_utf8);
  CHECK(message_of(with("small", "\xed\xa0\x80")) == "1: " + not_utf8);
  CHECK(message_of(kRightCase + "# \xc3(\n") == "33: " + not_utf8);
  CHECK(message_of(with("small", std::string(1, '\0'))) == control);
  CHECK(message_of(with("small", "\x1b[31m")) == control);
  CHECK(message_of(with("small", "\\u001b[31m")) == "accepted");
  CHECK(message_of(kRightCase + '\0') ==
        "33: Error while parsing root table: expected keys, tables, whitespace or comments, saw "
        "'\\u0000'");
  CHECK(message_of(with("small", "\\ud800")) ==
        scalar + "unicode surrogates (U+D800 - U+DFFF) are explicitly prohibited");
  CHECK(message_of(with("small", "\\U00110000")) ==
        scalar + "values greater than U+10FFFF are invalid");
}

TEST_CASE("ends of lines and of the file") {
  std::string crlf;
  std::string cr;
  for (const char c : kRightCase) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  CHECK(message_of(crlf) == "accepted");
  CHECK(message_of(cr) ==
        "1: Error while parsing key-value pair: expected '\\n' after '\\r', saw 'd'");
  CHECK(message_of(kRightCase.substr(0, kRightCase.size() - 1)) == "accepted");
  CHECK(message_of(kRightCase + "x = \"abc") ==
        "33: Error while parsing string: encountered end-of-file");
  CHECK(message_of(kRightCase + "x = \"\"\"abc\n") ==
        "33: Error while parsing string: encountered end-of-file");
}

TEST_CASE("what nests too deep is refused before it fills the stack") {
  const std::string deep_value =
      "33: Error while parsing value: exceeded maximum nested value depth of 256 "
      "(TOML_MAX_NESTED_VALUES)";
  const std::string deep_key = "33: more than 100 dots in a row of names";
  CHECK(message_of(kRightCase + "x = " + repeat("[", 1000000)) == deep_value);
  CHECK(message_of(kRightCase + "x = " + repeat("{a=", 1000000)) == deep_value);
  CHECK(message_of(kRightCase + repeat("a.", 1000000) + "a = 1\n") == deep_key);
  CHECK(message_of(kRightCase + "[" + repeat("a.", 1000000) + "a]\n") == deep_key);
  CHECK(message_of(kRightCase + repeat("\"a\" . ", 1000000) + "a = 1\n") == deep_key);
  CHECK(message_of(kRightCase + "x = {" + repeat("a.", 1000000) + "a = 1}\n") == deep_key);
  CHECK(message_of(kRightCase + repeat("a.", 100) + "a = 1\n") ==
        "33: time.a: unknown key; the keys here are steps, duration, step_factor, integrator");
}

TEST_CASE("a file of ten megabytes is read, and one without end is not") {
  CHECK(message_of(kRightCase + "# " + repeat("x", 10000000)) == "accepted");
  CHECK(message_of(kRightCase + "x = \"" + repeat("x", 10000000) + "\"\n") ==
        "33: time.x: unknown key; the keys here are steps, duration, step_factor, integrator");
  CHECK_THROWS_MATCHES(
      rgimp::read_case("/dev/zero"), rgimp::FileError,
      Catch::Matchers::Message("cannot read /dev/zero: longer than 64 MiB, which no case file is"));
}
