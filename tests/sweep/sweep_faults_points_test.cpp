// Every fault of the points of a sweep file: knobs, where, base and named points.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "tests/sweep/sweep_text.h"

namespace racebeam {
namespace {

const BadSweep BadPoints[] = {
    {"KnobsIsList", "knobs = [1]\n", "1:9: 'knobs' is an array", "a table of knobs"},
    {"UnknownKnob", "[knobs]\nfifo_entrys = 4\n", "2:1: unknown knob 'fifo_entrys'",
     "'fifo_entries'?"},
    {"KnobOfScene", "[knobs]\nfree_flight = 1\n", "2:1: knob 'free_flight' is the scene's",
     "the scene file sets it"},
    {"ValueTooSmall", "[knobs]\nfifo_entries = 2\n", "2:16: 'fifo_entries' is 2", "3..64: entries"},
    {"ValueTooLargeInList", "[knobs]\nfifo_entries = [4,\n  65]\n", "3:3: 'fifo_entries' is 65",
     "3..64: entries"},
    {"ValueIsText", "[knobs]\nfifo_entries = \"4\"\n", "2:16: 'fifo_entries' is a string",
     "a whole number 3..64"},
    {"ValueHasPoint", "[knobs]\nfifo_entries = [4.0]\n", "2:17: 'fifo_entries' is a number with",
     "a whole number 3..64"},
    {"UnknownWord", "[knobs]\nbisection = [\"pow2\", \"pow3\"]\n", "2:22: 'bisection' is 'pow3'",
     "pow2, midpoint"},
    {"NumberForWord", "[knobs]\nbisection = 0\n", "2:13: 'bisection' is a whole number",
     "it must be one of pow2, midpoint, floor, in quotes"},
    {"BooleanForWord", "[knobs]\ndithering = [\"on\", false]\n",
     "2:20: 'dithering' is true or false", "it must be one of off, on, checkered, in quotes"},
    {"EmptyList", "[knobs]\nfifo_entries = []\n", "2:16: 'fifo_entries' has an empty list",
     "leave the knob out"},
    {"RangeOfWords", "[knobs]\nbisection = { from = 0, to = 1 }\n",
     "2:13: 'bisection' is a range, but its values are names", "pow2, midpoint"},
    {"RangeBackwards", "[knobs]\nfifo_entries = { from = 16, to = 4, step = 2 }\n",
     "2:25: 'from' is 16 and 'to' is 4", "'from' is the smaller one"},
    {"StepOfZero", "[knobs]\nfifo_entries = { from = 4, to = 16, step = 0 }\n", "2:44: 'step' is 0",
     "1..61"},
    {"StepBelowZero", "[knobs]\nfifo_entries = { from = 4, to = 16, step = -1 }\n",
     "2:44: 'step' is -1", "1..61"},
    {"RangeWithoutTo", "[knobs]\nfifo_entries = { from = 4 }\n", "2:16: 'range' has no 'to'",
     "{ from = 4, to = 16, step = 2 }"},
    {"RangeWithoutFrom", "[knobs]\nfifo_entries = { to = 4 }\n", "2:16: 'range' has no 'from'",
     "{ from = 4, to = 16, step = 2 }"},
    {"RangeBeyond", "[knobs]\nfifo_entries = { from = 4, to = 65 }\n", "2:33: 'to' is 65",
     "3..64: entries"},
    {"UnknownRangeKey", "[knobs]\nfifo_entries = { from = 4, to = 6, stride = 1 }\n",
     "2:36: unknown key 'stride' in 'range'", "'step'?"},

    {"WhereIsNumber", "[knobs]\nwhere = 3\n", "2:9: 'where' is a whole number", "in quotes"},
    {"WhereUnknownKnob", "[knobs]\nwhere = \"fifo_entrees < 3\"\n",
     "2:9: there is no knob 'fifo_entrees'; did you mean 'fifo_entries'?", "over knobs"},
    {"WhereKnobOfScene", "[knobs]\nwhere = \"navigator_bits < 3\"\n",
     "2:9: there is no knob 'navigator_bits'", "over knobs"},
    {"WhereAssigns", "[knobs]\nwhere = \"fifo_entries = 3\"\n",
     "2:9: where 'fifo_entries = 3': '=' at character 14; to compare write '=='", "over knobs"},
    {"WhereBroken", "[knobs]\nwhere = \"fifo_entries <\"\n",
     "2:9: where 'fifo_entries <': ", "over knobs"},
    {"WhereEmpty", "[knobs]\nwhere = \"\"\n", "2:9: where ''", "over knobs"},
    {"WhereNoKnob", "[knobs]\nwhere = \"3 < 4\"\n", "2:9: where '3 < 4' names no knob",
     "over knobs"},
    {"WhereUnknownWord", "[knobs]\nwhere = \"bisection == pow3\"\n",
     "2:9: where 'bisection == pow3': bisection has no value 'pow3' (there is: pow2, midpoint, "
     "floor)",
     "over knobs"},
    {"WhereTooLong", "[knobs]\nwhere = \"" + std::string(2000, '(') + "\"\n",
     "2:9: where has 2000 characters; it may have 1000", "over knobs"},
    {"WhereWithEscape", "[knobs]\nwhere = \"\\u001b[31m\"\n",
     "2:9: 'where' has characters that mean nothing in it", "over knobs"},
    {"WhereLeavesNothing", "[knobs]\nfifo_entries = [4, 5]\nwhere = \"fifo_entries > 5\"\n",
     "3:9: 'where' leaves no point", "allow more"},
    {"WhereLeavesNothingOneByOne",
     "search.method = \"one-by-one\"\n[knobs]\nfifo_entries = [4]\nwhere = \"dr_bits > 10\"\n",
     "4:9: 'where' leaves no point", "allow more"},
    {"WhereLeavesNothingOfSobol",
     "search.method = \"sobol\"\n[knobs]\nfifo_entries = [4]\nwhere = \"fifo_entries > 5\"\n",
     "4:9: 'where' leaves no point", "allow more"},

    {"PointIsTable", "[point]\nname = \"a\"\n", "1:1: 'point' is a table", "[[point]]"},
    {"PointWithoutName", "[[point]]\nknobs = {}\n", "1:1: 'point' has no 'name'",
     "name = \"no limits\""},
    {"UnknownPointKey", "[[point]]\nname = \"a\"\nknob = {}\n",
     "3:1: unknown key 'knob' in 'point'", "'knobs'?"},
    {"PointKnobUnknown", "[[point]]\nname = \"a\"\nknobs = { fifo_entry = 3 }\n",
     "3:11: unknown knob 'fifo_entry'", "'fifo_entries'?"},
    {"PointKnobIsList", "[[point]]\nname = \"a\"\nknobs = { fifo_entries = [4] }\n",
     "3:26: 'fifo_entries' is an array", "a whole number"},
    {"PointKnobHasNoWhere", "[[point]]\nname = \"a\"\nknobs = { where = \"dr_bits > 3\" }\n",
     "3:11: unknown knob 'where'", "racebeam knobs"},
    {"PointKnobsIsList", "[[point]]\nname = \"a\"\nknobs = []\n", "3:9: 'knobs' is an array",
     "{ fifo_entries = 8 }"},
    {"TwoPointsOfOneName", "[[point]]\nname = \"a\"\n[[point]]\nname = \"a\"\n",
     "4:8: the name 'a' is used twice", "in line 2"},
    {"PointNamedAsBase", "[[point]]\nname = \"chip\"\n", "2:8: the name 'chip' is used twice",
     "the base point"},
    {"PointNamedAsNamedBase", "[base]\nname = \"old\"\n[[point]]\nname = \"old\"\n",
     "4:8: the name 'old' is used twice", "in line 2"},
    {"PointNamedAsSearch", "[[point]]\nname = \"p31\"\n",
     "2:8: the name 'p31' is one of the search's points", "choose another"},
    {"BaseNamedAsSearch", "[base]\nname = \"p1\"\n", "2:8: the name 'p1' is one of the search's",
     "choose another"},
    {"UnknownBaseKey", "[base]\nfifo_entries = 3\n", "2:1: unknown key 'fifo_entries' in 'base'",
     "there is: name, knobs"},
    {"BaseKnobOutOfRange", "[base]\nknobs.dr_bits = 7\n", "2:17: 'dr_bits' is 7", "8..13: bits"},
};

class SweepPointFaultTest : public testing::TestWithParam<BadSweep> {};

TEST_P(SweepPointFaultTest, HasItsPlaceAndHelpAndIsTheOnlyOne) { expect_fault(GetParam()); }

INSTANTIATE_TEST_SUITE_P(All, SweepPointFaultTest, testing::ValuesIn(BadPoints),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace racebeam
