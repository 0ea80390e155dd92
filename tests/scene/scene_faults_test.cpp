// Every fault of a scene file, with its line, its column and what to do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <ostream>
#include <random>

#include "tests/support/scene_text.h"

namespace racebeam {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Bad {
  const char* name;
  std::string text;
  std::string fault;  ///< "LINE:COLUMN: what"
  std::string help;
};

// A cell and a camera in line 1 and 2, `more` from line 3 on.
std::string cell_and(const std::string& more) { return "plan.storeys = \"@\"\n\n" + more; }

const Bad BadScenes[] = {
    {"Nothing", "", "1:1: the scene has no rooms", "[plan]"},
    {"EmptyListOfRooms", "room = []\n", "1:1: the scene has no rooms", "[[room]]"},
    {"NotToml", "frames = \n", "1:10: not TOML", "toml.io"},
    {"DoubledKey", "frames = 1\nframes = 2\n", "2:10: not TOML", "toml.io"},
    {"HeaderWithoutKey", "[[ = 3\n", "1:4: not TOML", "toml.io"},
    {"LetterBeyondAscii", "\u00e9 = 3\n", "1:1: not TOML", "toml.io"},
    {"UnknownTopKey", cell_and("[camra]\n"), "3:2: unknown key 'camra' in the file", "'camera'?"},
    {"UnknownCameraKey", cell_and("[camera]\n  yew = 3\n"), "4:3: unknown key 'yew'", "'yaw'?"},
    {"UnknownKeyInline", cell_and("camera = { yaw = { stp = 1 } }\n"), "3:20: unknown key 'stp'",
     "'step'?"},
    {"WrongType", cell_and("[camera]\nroom = 7\n"), "4:8: 'room' is a whole number",
     "a text in quotes"},
    {"TableWanted", "camera = 3\n" + cell_and(""), "1:10: 'camera' is a whole number", "a table"},
    {"FramesOutOfRange", "frames = 0\n" + cell_and(""), "1:10: 'frames' is 0", "1..16383"},
    {"MoreFramesThanTheCounterHolds", "frames = 16384\n" + cell_and(""), "1:10: 'frames' is 16384",
     "1..16383: the chip's frame counter has 14 bits"},
    {"ShotBeyondTheCounter", cell_and("[[shot]]\nframe = 16383\n"), "4:9: 'frame' is 16383",
     "1..16382: the chip's frame counter has 14 bits"},
    {"HugeNumber", "frames = 9223372036854775807\n" + cell_and(""), "1:10: 'frames' is 92233",
     "1..16383"},
    {"TooHugeNumber", "frames = 99999999999999999999\n", "1:30: not TOML", "toml.io"},
    {"NotANumber", "frames = nan\n" + cell_and(""), "1:10: 'frames' is not a finite number",
     "1..16383"},
    {"Infinite", "frames = -inf\n" + cell_and(""), "1:10: 'frames' is not a finite number",
     "1..16383"},
    {"Fraction", "frames = 1.5\n" + cell_and(""), "1:10: 'frames' is a number with a point",
     "a whole number"},
    {"Date", "frames = 1979-05-27\n" + cell_and(""), "1:10: 'frames' is a date", "a whole number"},
    {"UnknownEngine", "engine = \"bean\"\n" + cell_and(""), "1:10: 'engine' is 'bean'",
     "it must be one of beam"},
    {"NotABoolean", "wrap = 1\n" + cell_and(""), "1:8: 'wrap' is a whole number", "true or false"},
    {"ShortVector", cell_and("[camera]\nposition = [1, 2]\n"), "4:12: 'position' is an array",
     "[x, y, z]"},
    {"VectorOfTexts", cell_and("[camera]\nposition = [1, 2, \"3\"]\n"),
     "4:19: 'position' is a string", "a whole number"},
    {"BadColour", cell_and("[look]\npalette = [\"000\", \"111\", \"004\", \"222\"]\n"),
     "4:26: a colour of 'palette' is not three digits", "\"300\" or [3, 0, 0] is red"},
    {"ColourPartTooLarge", cell_and("[look]\npalette = [\"000\", [0, 4, 0], \"004\", \"222\"]\n"),
     "4:19: a colour of 'palette' is not three digits", "[3, 0, 0] is red"},
    {"ColourOfTwoParts", cell_and("[look]\npattern_palette = [[0, 1], \"0\", \"1\", \"2\"]\n"),
     "4:20: a colour of 'pattern_palette' is not three digits", "[3, 0, 0] is red"},
    {"ColourOfTexts",
     cell_and("[look]\npalette = [[\"0\", \"1\", \"2\"], \"000\", \"111\", \"222\"]\n"),
     "4:12: a colour of 'palette' is not three digits", "[3, 0, 0] is red"},
    {"EmptyShotName", cell_and("[[shot]]\nframe = 9\nname = \"\"\n"), "5:8: 'name' is empty",
     "a name"},
    {"ShotNameIsNumber", cell_and("[[shot]]\nframe = 9\nname = 3\n"),
     "5:8: 'name' is a whole number", "a text in quotes"},
    {"ThreeColours", cell_and("[look]\npalette = [\"000\", \"111\", \"222\"]\n"),
     "4:11: 'palette' is an array", "four colours"},
    {"UnknownWord", cell_and("[look]\nshading = \"flat\"\n"), "4:11: 'shading' is 'flat'",
     "axis, dithered"},
    {"UnknownCameraRoom", cell_and("[camera]\nroom = \"strat\"\n"), "4:8: there is no room 'strat'",
     "'start'?"},
    {"UnknownShotRoom", cell_and("[[shot]]\nframe = 9\ncamera.room = \"\\u00e9x\"\n"),
     "5:15: there is no room '??x'", "there is: start"},
    {"NoCameraRoom", "[plan]\nstoreys = \".\"\n", "1:1: the camera has no room", "'@'"},
    {"CameraOutside", cell_and("[camera]\nposition = [0, 0, 128]\n"),
     "4:12: the camera is outside of its room 'start'", "128, 256, 128"},
    {"CameraMeetsWall", cell_and("[camera]\nvelocity = [0, 0, 2]\n"),
     "3:1: in frame 66 the camera leaves 'start' through its north face", "frames = 66"},
    {"DoubledId",
     TwoRooms + "[[room]]\nid = \"a\"\ncentre = [0, 0, 512]\nhalf_size = [1, 1, 128]\n",
     "13:6: the room id 'a' is used twice", "line 4"},
    {"MissingId", TwoRooms + "[[room]]\ncentre = [0, 0, 512]\nhalf_size = [1, 1, 128]\n",
     "12:1: 'room' has no 'id'", "id = "},
    {"EmptyId", TwoRooms + "[[room]]\nid = \"\"\ncentre = [0, 0, 512]\nhalf_size = [1, 1, 1]\n",
     "13:6: 'id' is empty", "a name"},
    {"Overlap", TwoRooms + "[[room]]\nid = \"c\"\ncentre = [0, 0, 300]\nhalf_size = [9, 9, 9]\n",
     "13:6: rooms 'b' and 'c' overlap", "line 9"},
    {"UnknownPortal", TwoRooms + "portals = { up = \"c\" }\n", "12:18: there is no room 'c'",
     "'a'?"},
    {"PortalDoesNotTouch", TwoRooms + "portals = { east = \"a\" }\n",
     "12:20: the east face of 'b' does not touch 'a'", "in common"},
    {"UnknownFace", TwoRooms + "portals = { nort = \"a\" }\n", "12:13: unknown key 'nort'",
     "'north'?"},
    {"HalfSizeOfZero",
     TwoRooms + "[[room]]\nid = \"c\"\ncentre = [0, 0, 512]\nhalf_size = [1, 0, 1]\n",
     "15:17: 'half_size' is 0", "1..8191"},
    {"CornerBitsTooFew", "corner_bits = 10\n" + TwoRooms, "5:6: seen from 'a', a corner of 'a'",
     "wrap = true"},
    {"ShotsNotTables", cell_and("shot = 3\n"), "3:8: 'shot' is a whole number", "[[shot]]"},
};

class SceneFaultTest : public testing::TestWithParam<Bad> {};

TEST_P(SceneFaultTest, HasItsPlaceAndHelp) {
  EXPECT_THAT(faults_of(GetParam().text), AllOf(HasSubstr("f:" + GetParam().fault),
                                                HasSubstr("help: "), HasSubstr(GetParam().help)));
}

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.text; }

INSTANTIATE_TEST_SUITE_P(All, SceneFaultTest, testing::ValuesIn(BadScenes),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SceneFaultsTest, AllAreReportedAtOnceInTheOrderOfTheFile) {
  const std::string faults =
      faults_of("frames = 0\nwrap = 1\n[plan]\nstoreys = \"@x\"\ncell = 3\n");
  const char* const places[] = {"f:1:10:", "f:2:8:", "f:4:", "f:5:8: 'cell' is odd"};
  std::size_t at = 0;
  for (const char* place : places) {
    const std::size_t found = faults.find(place, at);
    ASSERT_NE(found, std::string::npos) << place << "\n" << faults;
    at = found;
  }
}

TEST(SceneFaultsTest, WithoutRoomsTheCameraIsNotBlamed) {
  EXPECT_THAT(faults_of("[camera]\nroom = \"a\"\n[[shot]]\nframe = 1\ncamera.room = \"b\"\n"),
              AllOf(HasSubstr("1:1: the scene has no rooms"), Not(HasSubstr("there is no room"))));
}

TEST(SceneFaultsTest, ThousandsAreCountedNotListed) {
  Faults faults;
  for (int i = 0; i < 5000; ++i) faults.add({i, 1}, "bad", "mend it");
  EXPECT_EQ(faults.count(), 5000);
  EXPECT_THAT(faults.text("f"), HasSubstr("f: and 4000 more faults\n"));
}

TEST(SceneFaultsTest, NothingReachesTheTerminalUnquoted) {
  const std::string faults = faults_of("\"\\u001b[31m\\n\" = 1\n" + cell_and(""));
  EXPECT_THAT(faults, HasSubstr("'?[31m?'"));
  EXPECT_EQ(faults.find('\x1b'), std::string::npos);
}

TEST(SceneFaultsTest, DeepNestingIsRefused) {
  for (const int depth : {17, 300, 100000}) {
    std::string arrays = "name = " + std::string(depth, '['), dots = "a", tables = "name = ";
    for (int i = 0; i < depth; ++i) dots += ".a", tables += "{a=";
    EXPECT_THAT(faults_of(arrays), StartsWith("f:1:"));
    EXPECT_THAT(faults_of(arrays + std::string(depth, ']')), HasSubstr("nested too deeply"));
    EXPECT_THAT(faults_of(dots + " = 1\n"), HasSubstr("nested too deeply"));
    EXPECT_THAT(faults_of("[" + dots + "]\n"), HasSubstr("nested too deeply"));
    EXPECT_THAT(faults_of(tables), StartsWith("f:1:"));
  }
}

TEST(SceneFaultsTest, DotsInTextsAndCommentsAreNoNesting) {
  good_scene(
      "# ........................\nname = \"....................\"\n[plan]\nstoreys = \"\"\"\n" +
      std::string(30, '.') + "@\n\"\"\"\n");
}

TEST(SceneFaultsTest, AMegabyteOfRandomBytesIsRefused) {
  std::mt19937 random(1);
  for (const bool printable : {false, true}) {
    std::string bytes(1 << 20, ' ');
    for (char& byte : bytes)
      byte = static_cast<char>(printable ? 32 + random() % 95 : random() % 256);
    EXPECT_THAT(faults_of(bytes), HasSubstr("not TOML"));
  }
}

TEST(SceneFaultsTest, AFaultyRoomIsOneFault) {
  const std::string text = R"([camera]
room = "hall"
position = [500, 0, 0]
[[room]]
id = "hall"
centre = [0, 0, 0]
half_size = [128, 256]
[[room]]
id = "bath"
centre = [0, 0, 256]
half_size = [128, 256, 128]
portals = { south = "hall", north = "kitchen" }
)";
  const std::string faults = faults_of(text);
  EXPECT_THAT(
      faults,
      AllOf(HasSubstr("f:7:13: 'half_size' is an array"), HasSubstr("there is no room 'kitchen'"),
            Not(HasSubstr("there is no room 'hall'")), Not(HasSubstr("outside of its room"))));
}

TEST(SceneFaultsTest, TwoMarksForTheCameraAreNamedWithBothPlaces) {
  const std::string faults = faults_of("[plan]\nstoreys = \"\"\"\n@..\n..@\n\"\"\"\n");
  EXPECT_THAT(faults,
              StartsWith("f:4:3: '@' stands in line 3, column 1 and in line 4, column 3\n"));
  EXPECT_THAT(faults, Not(HasSubstr("has no room")));
}

}  // namespace
}  // namespace racebeam
