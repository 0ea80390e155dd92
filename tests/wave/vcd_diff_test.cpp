// Promises of tb/wave/vcd_reader.h and vcd_diff.h, on dumps as other programs write them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/vcd_diff.h"

#include <gmock/gmock.h>

#include <memory>
#include <sstream>

#include "tb/base/errors.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

VcdReader reader(const std::string& text) {
  return {std::make_unique<std::istringstream>(text), "the dump"};
}

VcdComparison compared(const std::string& a, const std::string& b) {
  VcdReader reader_a = reader(a), reader_b = reader(b);
  return compare_vcds(reader_a, reader_b, [](const std::string&) { return true; });
}

/// "time: path a b, path a b" of the first difference.
std::string difference(const std::string& a, const std::string& b) {
  const auto first = compared(a, b).first;
  if (!first) return "none";
  std::string text = first->time + ":";
  for (const auto& row : first->rows) text += " " + row.path + " " + row.a + " " + row.b;
  return text;
}

std::string refused(const std::string& a, const std::string& b) {
  try {
    compared(a, b);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "taken";
}

// One bit and one vector of 8 in the scope top.
std::string dump(const std::string& changes, const std::string& scale = "1 ps") {
  return "$timescale " + scale +
         " $end $scope module top $end $var wire 1 ! a $end $var wire 8 \" d [7:0] $end $upscope "
         "$end $enddefinitions $end\n" +
         changes;
}

// As Icarus writes them: parameters before the first time, and a block of them at it.
TEST(VcdDiff, ValuesBeforeTheFirstTimeBelongToIt) {
  const std::string rest = "#0\n$dumpvars\n1!\n$end\n#5\n0!\n";
  const auto with = [&](const std::string& digits) {
    return dump("$comment Show the parameter values. $end\n$dumpall\nb" + digits + " \"\n$end\n" +
                rest);
  };
  EXPECT_EQ(difference(with("101"), with("101")), "none");
  EXPECT_EQ(difference(with("101"), with("100")), "0 ps: top.d 0x05 0x04");
  EXPECT_EQ(difference(with("101"), dump("#0\nb101 \"\n1!\n#5\n0!\n")), "none");
  EXPECT_EQ(difference(dump("$dumpvars 1! $end"), dump("$dumpvars 0! $end")), "0 ps: top.a 1 0");
}

TEST(VcdDiff, EachBitOfAVectorIsASignalOfItsOwn) {
  const auto bits = [](const std::string& changes) {
    return "$var wire 1 ! q [0] $end $var wire 1 \" q [1] $end $var wire 4 # q[5:2] $end "
           "$var wire 8 $ r[0:7] $end $enddefinitions $end\n" +
           changes;
  };
  EXPECT_THAT(reader(bits("")).paths(), ElementsAre("q[0]", "q[1]", "q[5:2]", "r"));
  EXPECT_EQ(difference(bits("#0\n0!\n1\"\nb0 #\n"), bits("#0\n0!\n0\"\nb1 #\n")),
            "0 ns: q[1] 1 0 q[5:2] 0x0 0x1");
}

TEST(VcdDiff, OfTwoSignalsWithOneNameNoneIsLost) {
  const std::string head =
      "$scope module g[2] $end $var wire 1 ! q $end $var wire 1 \" q $end $var wire 1 ! q $end "
      "$upscope $end $enddefinitions $end\n";
  EXPECT_THAT(reader(head).paths(), ElementsAre("g[2].q", "g[2].q'"));
  EXPECT_EQ(difference(head + "#0\n0!\n0\"\n", head + "#0\n0!\n1\"\n"), "0 ns: g[2].q' 0 1");
}

TEST(VcdDiff, TimesAreComparedInOneUnit) {
  EXPECT_EQ(difference(dump("#0\n1!\n#5\n0!\n", "1ns"), dump("#0\n1!\n#5000\n0!\n")), "none");
  EXPECT_EQ(difference(dump("#0\n1!\n#5\n0!\n", "10 ns"), dump("#0\n1!\n#500\n0!\n", "100 ps")),
            "none");
  EXPECT_EQ(difference(dump("#0\n1!\n#5\n0!\n#9\n", "1ns"), dump("#0\n1!\n#5\n0!\n#9000\n")),
            "5 ps: top.a 1 0");
  EXPECT_EQ(difference(dump("#0\n1!\n#7\n0!\n", "100us"), dump("#0\n1!\n#7\n1!\n", "100us")),
            "700 us: top.a 0 1");
  EXPECT_THAT(refused(dump("#1\n1!\n", "2 ps"), dump("")), HasSubstr("a time scale of '2ps'"));
  EXPECT_THAT(refused(dump("#1000000\n1!\n", "1 s"), dump("#1\n1!\n", "1 fs")),
              HasSubstr("too far away"));
}

TEST(VcdDiff, BlocksBetweenChangesAreRead) {
  const std::string plain = dump("#0\n0!\nb1 \"\n#5\n1!\n#9\nbx \"\n#12\n");
  EXPECT_EQ(difference(plain, dump("#0\n$dumpvars 0! b1 \" $end\n$comment #3 1! $end\n#5\n1!\n"
                                   "$dumpall 1! b1 \" $end\n#9\n$dumpoff bX \" $end\n#12\n")),
            "none");
  EXPECT_THAT(refused(plain, dump("#0\n0!\n$comment it never ends\n#5\n")),
              HasSubstr("$end is missing"));
}

TEST(VcdDiff, DigitsAreReadInBothCasesAndLengths) {
  const std::string plain = dump("#0\nz!\nb1x0 \"\n#5\nx!\nbz \"\n");
  EXPECT_EQ(difference(plain, dump("#0\nZ!\nB000001X0 \"\n#5\nX!\nBZZZZ \"\n")), "none");
  EXPECT_EQ(difference(plain, dump("#0\nz!\nb1x1 \"\n")), "0 ps: top.d 1x0 1x1")
      << "both are x as numbers";
  EXPECT_EQ(difference(dump("#0\nb0x \"\n"), dump("#0\nbx \"\n")), "0 ps: top.d 0x x")
      << "x goes on to the left, and 0 does not";
  EXPECT_EQ(difference(dump("#0\nb1 \"\n"), dump("#0\nb101000000001 \"\n")), "none")
      << "no more digits than the signal has";
  const std::string real = "$var real 64 ! r $end $enddefinitions $end\n#0\n";
  EXPECT_EQ(difference(real + "r1.5 !\n", real + "R-2 !\n"), "0 ns: r 1.5 -2");
  EXPECT_THAT(refused(plain, dump("#0\nb12 \"\n")), HasSubstr("a value of 'b12'"));
}

TEST(VcdDiff, OneMomentMayBeWrittenInParts) {
  EXPECT_EQ(difference(dump("#0\n1!\n#5\n0!\n#5\n1!\n#9\n"), dump("#0\n1!\n#9\n")), "none");
  EXPECT_THAT(refused(dump("#5\n1!\n#4\n"), dump("#0\n1!\n#9\n")), HasSubstr("runs backwards"));
}

TEST(VcdDiff, ValuesAreShownAsInGtkWave) {
  const auto beam = [](const std::string& changes) {
    return "$scope module beam $end $var wire 14 ! frame [13:0] $end $var wire 10 \" line [9:0] "
           "$end $var wire 11 # clock [10:0] $end $var wire 64 $ wide [63:0] $end $upscope $end "
           "$enddefinitions $end #0 b111100 ! b1011101111 \" b0 # b" +
           std::string(64, '1') + " $\n" + changes;
  };
  const auto first =
      compared(beam("#7 b1011110000 \" b11 #"), beam("#7 b1 \" b11 # b1 $ #8")).first;
  ASSERT_TRUE(first);
  EXPECT_EQ(first->place, "frame 60, line -272, clock 3");
  ASSERT_EQ(first->rows.size(), 2u);
  EXPECT_EQ(first->rows[0].a + " " + first->rows[0].b, "-272 1");
  EXPECT_EQ(first->rows[1].a + " " + first->rows[1].b, "0xffffffffffffffff 0x0000000000000001");
}

TEST(VcdDiff, TheTimeThatBothHaveIsCompared) {
  const std::string early = dump("#0\n1!\nb11 \"\n#5\n0!\nb10 \"\n#9\n1!\n#12\n");
  const std::string late = dump("#7\n0!\nb10 \"\n#9\n1!\n#14\n0!\n");
  const VcdComparison c = compared(early, late);
  EXPECT_FALSE(c.first);
  EXPECT_FALSE(c.same()) << "the windows differ";
  EXPECT_EQ(c.begin_a + ", " + c.begin_b + ", " + c.end, "0 ps, 7 ps, 12 ps");
  EXPECT_EQ(c.changes, 1u);
  EXPECT_EQ(difference(early, dump("#7\n0!\nb11 \"\n#9\n1!\n")), "7 ps: top.d 0x02 0x03");
  EXPECT_EQ(difference(dump("#7\n0!\n#9\n"), early), "7 ps: top.d unknown 0x02");
  EXPECT_TRUE(compared(early, early + "#99\n").same()) << "nothing happens after 12 ps";
  EXPECT_EQ(compared(early, dump("#0\n1!\nb11 \"\n#5\n")).end, "5 ps")
      << "a last time without changes is where the values end";
  EXPECT_THAT(refused(early, dump("#13\n1!\n")), HasSubstr("no time in common"));
}

}  // namespace
}  // namespace racebeam
