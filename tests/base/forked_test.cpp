// forked(): what a child process answers, or throws, arrives.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/forked.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// What throws `error` in a child.
template <class Error>
auto throwing(const Error& error) {
  return [error] { forked([&]() -> std::string { throw error; }); };
}

TEST(Forked, AnAnswerOfAnyLengthArrives) {
  const std::string answer(1'000'000, 'a');
  EXPECT_EQ(forked([&] { return answer; }), answer);
}

TEST(Forked, NothingThatTheChildChangesIsChangedHere) {
  int here = 1;
  EXPECT_EQ(forked([&] { return std::to_string(++here); }), "2");
  EXPECT_EQ(here, 1);
}

TEST(Forked, ErrorsArriveAsWhatTheyAre) {
  EXPECT_THAT(throwing(RtlError("a")), ThrowsMessage<RtlError>("a"));
  EXPECT_THAT(throwing(UsageError("b")), ThrowsMessage<UsageError>("b"));
  EXPECT_THAT(throwing(OutputError("c", "full")),
              ThrowsMessage<UsageError>(HasSubstr("; choose another place")));
  EXPECT_THAT(throwing(MissingTool("d")), ThrowsMessage<MissingTool>("d"));
  EXPECT_THAT(throwing(std::runtime_error("e")), ThrowsMessage<std::runtime_error>("e"));
  EXPECT_THROW(throwing(Interrupted())(), Interrupted);
}

TEST(Forked, AChildThatDiesIsTold) {
  EXPECT_THAT(([] {
                forked([]() -> std::string {
                  raise(SIGKILL);
                  return "";
                });
              }),
              ThrowsMessage<ChildDied>(HasSubstr("a child process")));
}

}  // namespace
}  // namespace racebeam
