#include <catch2/catch.hpp>

#include "case_text.hpp"
#include "rgimp/rgimp.hpp"
#include "wrong_case.hpp"

namespace {

using rgimp::testing::check_rows;
using rgimp::testing::kRightSolid;
using rgimp::testing::message_of;
using rgimp::testing::read_text;

const std::string kBox = "\"box\"\ncenter = [0.0, 0.0, 0.0]\nsize = [20e-3, 40e-3, 20e-3]";
const std::string kSlotAxes = "direction = [1.0, 1.0, 0.0]\nnormal = [-1.0, 1.0, 0.0]\n";

}  // namespace

TEST_CASE("the solid that the wrong ones are made from is right") {
  CHECK(message_of(kRightSolid) == "accepted");
}

TEST_CASE("words of two dimensions are refused in three, and the other way round") {
  check_rows(
      {
          {"\"box\"", "\"disk\"", "6: body[0].shape: \"disk\" is not one of box, cylinder, sphere"},
          {"\"slot\"", "\"circle\"",
           "11: flaw[0].shape: \"circle\" is not one of slot, box, sphere, penny"},
          {"\"top\"", "\"up\"",
           "29: platen[0].side: \"up\" is not one of top, bottom, left, right, front, back"},
          {"dimension = 3", "dimension = 2", "7: body[0].center: has 3 components; expected 2"},
      },
      kRightSolid);
  check_rows({
      {"\"box\"", "\"cylinder\"", "6: body[0].shape: \"cylinder\" is not one of box, disk"},
      {"\"slot\"", "\"sphere\"", "11: flaw[0].shape: \"sphere\" is not one of slot, circle, box"},
      {"side = \"top\"", "side = \"back\"",
       "26: platen[0].side: \"back\" is not one of top, bottom, left, right"},
      {"width = 1.5e-3", "width = 1.5e-3\ndepth = 1e-3",
       "15: flaw[0].depth: not read by shape \"slot\", which reads length, width, angle, ends"},
      {"width = 1.5e-3", "width = 1.5e-3\nnormal = [0, 1]",
       "15: flaw[0].normal: not read by shape \"slot\", which reads length, width, angle, ends"},
  });
}

TEST_CASE("vectors and sizes of solids of the wrong length or type are refused") {
  check_rows(
      {
          {"[20e-3, 40e-3, 20e-3]", "[20e-3, 40e-3]",
           "8: body[0].size: has 2 components; expected 3"},
          {"[20e-3, 40e-3, 20e-3]", "20e-3",
           "8: body[0].size: found a real number; expected an array of 3 real numbers"},
          {"[20e-3, 40e-3, 20e-3]", "[20e-3, 40e-3, true]",
           "8: body[0].size[2]: found a boolean; expected a real number"},
          {"\"box\"", "\"cylinder\"", "8: body[0].size: has 3 components; expected 2"},
          {"\"box\"", "\"sphere\"", "8: body[0].size: found an array; expected a real number"},
          {kBox, "\"cylinder\"\ncenter = [0.0, 0.0, 0.0]\nsize = 20e-3",
           "8: body[0].size: found a real number; expected an array of 2 real numbers"},
          {"material = \"rock\"", "material = \"rock\"\naxis = [0, 1, 0]",
           "10: body[0].axis: not read by shape \"box\""},
          {"cell_size = 1e-3", "cell_size = 1e-3\nmin = [0, 0]",
           "5: grid.min: has 2 components; expected 3"},
          {"normal = [0.0, 1.0, 1.0]", "normal = [0.0, 1.0]",
           "23: flaw[1].normal: has 2 components; expected 3"},
          {"normal = [0.0, 1.0, 1.0]", "",
           "18: flaw[1].normal: missing; expected an array of 3 real numbers"},
          {"normal = [0.0, 1.0, 1.0]", "normal = [0.0, 1.0, inf]",
           "23: flaw[1].normal[2]: is inf; expected a finite number"},
          {"normal = [0.0, 1.0, 1.0]", "normal = [0.0, 1.0, 1.0]\ndepth = 1e-3",
           "24: flaw[1].depth: not read by shape \"penny\", which reads length, width, normal"},
          {"\"penny\"", "\"sphere\"",
           "22: flaw[1].width: not read by shape \"sphere\", which reads length"},
      },
      kRightSolid);
}

TEST_CASE("directions that are none, or not at right angles, are refused") {
  check_rows(
      {
          {"normal = [0.0, 1.0, 1.0]", "normal = [0.0, 0.0, 0.0]",
           "23: flaw[1].normal: is of length 0; expected a direction"},
          {"normal = [0.0, 1.0, 1.0]", "normal = [1e-200, 0.0, 0.0]",
           "23: flaw[1].normal: is of length 1e-200; expected a direction"},
          {"normal = [0.0, 1.0, 1.0]", "normal = [1e200, 0.0, 0.0]",
           "23: flaw[1].normal: is of length 1e+200; expected a direction"},
          {"direction = [1.0, 1.0, 0.0]", "direction = [0, 0, 0]",
           "16: flaw[0].direction: is of length 0; expected a direction"},
          {"direction = [1.0, 1.0, 0.0]", "direction = [1.0, 1.0, 0.0]\nangle = 45.0",
           "16: flaw[0].direction: given besides angle; expected one of them"},
          {"normal = [-1.0, 1.0, 0.0]\n", "",
           "16: flaw[0].direction: given without normal; expected both or none"},
          {"direction = [1.0, 1.0, 0.0]\n", "",
           "16: flaw[0].normal: given without direction; expected both or none"},
          {"normal = [-1.0, 1.0, 0.0]", "normal = [0.0, 1.0, 0.0]",
           "17: flaw[0].normal: is 45 degrees from direction; expected a right angle"},
          {"normal = [-1.0, 1.0, 0.0]", "normal = [-1.0, 1.000001, 0.0]", "accepted"},
          {kSlotAxes, "angle = 30.0\n", "accepted"},
          {kBox, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, 0, 0]",
           "9: body[0].axis: is of length 0; expected a direction"},
          {kBox, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, -3, 0]",
           "accepted"},
          {kBox, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 40e-3]\naxis = [0, 1, 1]",
           "30: platen[0].side: the bodies' top end at y = 0.0212132 m is not on a grid line; "
           "expected a height of 0.042 or 0.043 m"},
      },
      kRightSolid);
}

TEST_CASE("values of solids out of range are refused") {
  check_rows(
      {
          {"[20e-3, 40e-3, 20e-3]", "[20e-3, 40e-3, 0]",
           "8: body[0].size[2]: is 0; expected a number above 0"},
          {kBox, "\"sphere\"\ncenter = [0, 0, 0]\nsize = -20e-3",
           "8: body[0].size: is -0.02; expected a number above 0"},
          {kBox, "\"cylinder\"\ncenter = [0, 0, 0]\nsize = [20e-3, 0]",
           "8: body[0].size[1]: is 0; expected a number above 0"},
          {"depth = 10e-3", "depth = 0", "15: flaw[0].depth: is 0; expected a number above 0"},
          {"depth = 10e-3", "depth = 1.9e-3",
           "15: flaw[0].depth: is 0.0019 m, 1.9 cells across; expected at least two cells, 0.002 "
           "m: nearer faces share grid nodes and stay glued"},
          {"width = 3e-3\nnormal", "width = 1.5e-3\nnormal",
           "22: flaw[1].width: is 0.0015 m, 1.5 cells across; expected at least two cells, 0.002 "
           "m: "
           "nearer faces share grid nodes and stay glued"},
          {"width = 3e-3\nnormal", "width = 9e-3\nnormal",
           "21: flaw[1].length: is 0.008; expected at least the width, 0.009"},
          {"center = [0.0, 10e-3, 0.0]", "center = [0.0, 10e-3, 15e-3]",
           "20: flaw[1].center: lies outside every body, so that no particle is left out; the "
           "bodies span (-0.01, -0.02, -0.01) to (0.01, 0.02, 0.01) m"},
          {"cell_size = 1e-3", "cell_size = 1e-5",
           "4: grid.cell_size: makes 1.62e+10 nodes; expected at most 2147483648"},
          {"side = \"front\"", "side = \"top\"",
           "32: platen[1].side: \"top\" is taken by platen[0]; expected a side of its own for each "
           "platen"},
      },
      kRightSolid);
}

TEST_CASE("solids that do not fit the grid or each other are refused") {
  const auto beside = [](const std::string& body) {
    return "[[body]]\n" + body + "\nmaterial = \"rock\"\n[[flaw]]";
  };
  check_rows(
      {
          {"40e-3, 20e-3]", "40e-3, 20.4e-3]",
           "32: platen[1].side: the bodies' front end at z = 0.0102 m is not on a grid line; "
           "expected a depth of 0.02 or 0.021 m"},
          {"cell_size = 1e-3", "cell_size = 1e-3\nmin = [-20e-3, -30e-3, -12e-3]",
           "5: grid.min: leaves 2 cells behind the bodies; expected at least 3"},
          {"cell_size = 1e-3", "cell_size = 1e-3\nmax = [20e-3, 30e-3, 12e-3]",
           "5: grid.max: leaves 2 cells in front of the bodies; expected at least 3"},
          {"half_width = 5e-3", "half_width = 0",
           "34: platen[1].half_width: is 0; expected a number above 0"},
          {"[[flaw]]", beside("shape = \"sphere\"\ncenter = [0, 0, 19e-3]\nsize = 20e-3"),
           "10: body[1]: reaches 0.001 m into body[0]; expected bodies that touch at most"},
          {"[[flaw]]",
           beside("shape = \"box\"\ncenter = [0, 0, 15e-3]\nsize = [9e-3, 9e-3, 12e-3]"),
           "10: body[1]: reaches 0.001 m into body[0]; expected bodies that touch at most"},
          {"[[flaw]]",
           beside("shape = \"cylinder\"\ncenter = [0, 0, 18e-3]\nsize = [8e-3, 20e-3]\naxis = [0, "
                  "0, 1]"),
           "10: body[1]: reaches 0.00175 m into body[0]; expected bodies that touch at most"},
      },
      kRightSolid);
}
