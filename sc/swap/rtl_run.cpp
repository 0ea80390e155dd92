// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_run.h"

#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "sc/swap/rtl_remarks.h"

namespace racebeam {

namespace {

constexpr std::uint64_t MostPrinted = 10'000'000;  // bytes
constexpr int Looks = 4;                           // at an evaluation that does not return
constexpr int Stuck = SIGVTALRM;                   // the signal of a look
constexpr int Patience = 2;                        // seconds to tell of RTL that was left
constexpr int ExitFault = 2;

/// The evaluation that is going on, for signal handlers and for what RTL calls.
struct alignas(64) Evaluation {
  const rtl_model* model;
  const char* unit;  // the model lies in the heap, which RTL may break
  std::uint64_t clock;
  bool settled;                         // its inputs have the values of the clock
  bool excused;                         // an assertion that was told last, as they had not
  volatile sig_atomic_t inside;         // RTL runs, and nothing of ours
  volatile std::uint64_t number, seen;  // of the evaluation, and when the clock looked last
  volatile int looks;                   // in vain
  volatile int left_by;                 // the signal that ended it
  void* way_out[5];                     // of __builtin_setjmp: saves three registers, not nine
} now;

std::uint64_t printed = 0;
std::string last_line, line;  // printed: whole, and begun
std::function<bool(const std::string&)> listener;

/// Our own code runs inside RTL for a while.
class Outside {
 public:
  Outside() : before_(now.inside) { now.inside = 0; }
  ~Outside() { now.inside = before_; }

 private:
  const sig_atomic_t before_;
};

std::string place(const char* file, int line_number) {
  if (!file || !*file) return "";
  return nearer_path(file) + ":" + std::to_string(line_number) + ": ";
}

std::string in_clock() {
  return std::string("the RTL of ") + now.unit + " has ended the simulation in clock " +
         std::to_string(now.clock) + ": ";
}

/// What $fatal and $error print before they stop: "[5] %Error: mine.sv:7: Assertion failed in
/// TOP.stacks: boom".
std::string said() {
  const std::string& text = line.empty() ? last_line : line;
  if (text.find("%Error: ") == std::string::npos && text.find("%Fatal: ") == std::string::npos)
    return "$stop";
  const std::string where = "Assertion failed in ";
  const auto name = text.find(where);
  const auto colon = name == std::string::npos ? name : text.find(": ", name + where.size());
  return "error" + (colon == std::string::npos ? "" : text.substr(colon));
}

/// What is printed of an assertion that fails, and by $error.
bool is_assertion(const std::string& text) {
  return text.find("%Error: ") != std::string::npos &&
         text.find("Assertion failed in ") != std::string::npos;
}

void print(const char* format, va_list values) {
  const Outside ours;
  char* text = nullptr;
  if (vasprintf(&text, format, values) < 0) return;
  const std::string all(text);
  std::free(text);
  now.excused = !now.settled && is_assertion(all);
  if (now.excused) return;
  if (listener && listener(all)) return;
  std::fputs(all.c_str(), stderr);
  printed += all.size();
  for (const char c : all) {
    if (c != '\n') line += c;
    else last_line = std::exchange(line, "");
  }
  if (printed <= MostPrinted) return;
  throw RtlFault(in_clock() + "it printed more than 10 MB; the last line: " +
                 (line.empty() ? last_line : line).substr(0, 200));
}

void end(rtl_end how, const char* file, int line_number, const char* message) {
  const Outside ours;
  if (how == RtlStop && std::exchange(now.excused, false)) return;
  const std::string at = in_clock() + place(file, line_number);
  if (how == RtlFinish) throw RtlFault(at + "$finish");
  if (how == RtlStop) throw RtlFault(at + said());
  const std::string text = message;
  if (text.find("converge") == std::string::npos) throw RtlFault(at + text);
  const std::string loop = remarks_text(*now.model, "circular");
  throw RtlFault(in_clock() + "its logic does not settle; a signal depends on itself without a " +
                 "register between" + (loop.empty() ? "" : ": " + loop));
}

double seconds_to_return() {
  const char* wish = std::getenv("RACEBEAM_RTL_SECONDS");
  if (!wish || !*wish) return 10;
  char* end = nullptr;
  const double seconds = std::strtod(wish, &end);
  if (*end || !(seconds >= 0.1 && seconds <= 1e6))
    throw RtlError(std::string("RACEBEAM_RTL_SECONDS is '") + wish +
                   "'; write a number of seconds from 0.1 on");
  return seconds;
}

/// What leaves RTL by force may leave the heap locked or broken: then only these words are said.
struct {
  timer_t timer;
  char text[256];
} last_words;

[[noreturn]] void give_up() {
  if (write(STDERR_FILENO, last_words.text, std::strlen(last_words.text)) < 0) _exit(ExitFault);
  _exit(ExitFault);
}

void set(timer_t timer, double seconds, bool again) {
  struct itimerspec time {};
  time.it_value.tv_sec = static_cast<time_t>(seconds);
  time.it_value.tv_nsec =
      static_cast<long>((seconds - static_cast<double>(time.it_value.tv_sec)) * 1e9);
  if (again) time.it_interval = time.it_value;
  timer_settime(timer, 0, &time, nullptr);
}

/// The processor time of this process alone: timers are not inherited.
void start_clocks() {
  struct sigevent event {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = Stuck;
  timer_t timer{};
  if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) == 0)
    set(timer, seconds_to_return() / Looks, true);
  event.sigev_value.sival_ptr = &last_words;
  if (timer_create(CLOCK_MONOTONIC, &event, &last_words.timer) != 0) last_words.timer = nullptr;
}

void look(int, siginfo_t* info, void*) {
  if (info->si_code == SI_TIMER && info->si_value.sival_ptr == &last_words) give_up();
  if (!now.inside || now.number != now.seen) {
    now.seen = now.number;
    now.looks = 0;
    return;
  }
  now.looks = now.looks + 1;
  if (now.looks >= Looks) leave_rtl(Stuck);
}

void crashed(int number) {
  leave_rtl(number);
  if (*last_words.text) give_up();
  signal(number, SIG_DFL);
  raise(number);  // once this handler has returned
}

/// Once in a process, and its children have it too.
void watch() {
  static bool watching = false;
  if (std::exchange(watching, true)) return;
  static char stack[1 << 16];  // the crash may be that the other one is full
  stack_t other{};
  other.ss_sp = stack;
  other.ss_size = sizeof stack;
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = crashed;
  action.sa_flags = SA_ONSTACK;
  for (const int number : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT})
    sigaction(number, &action, nullptr);
  action.sa_sigaction = look;
  action.sa_flags = SA_ONSTACK | SA_RESTART | SA_SIGINFO;
  sigaction(Stuck, &action, nullptr);
  start_clocks();
  pthread_atfork(nullptr, nullptr, start_clocks);
}

RtlFault left(int number) {
  static void* volatile some;
  std::free(some = std::malloc(100'000));  // more than a cache of the heap has without its lock
  const std::string begin = std::string("the RTL of ") + now.unit;
  const std::string clock = " in clock " + std::to_string(now.clock);
  if (number == SIGALRM) return RtlFault(begin + " did not return" + clock + "; interrupted");
  if (number == Stuck) {
    const std::string loops = remarks_text(*now.model, "loop");
    return RtlFault(begin + " does not return from clock " + std::to_string(now.clock) +
                    (loops.empty() ? "" : "; its loops: " + loops) +
                    "; if it needs its time, set RACEBEAM_RTL_SECONDS");
  }
  const std::vector<std::string> top = remarks_of(*now.model, "top");  // "FILE:LINE NAME"
  const std::string file = top.empty() ? "" : " (" + top[0].substr(0, top[0].rfind(':')) + ")";
  return RtlFault(begin + file + " crashed" + clock + ": " + strsignal(number));
}

/// step(top); false if a signal handler has left it. A function of its own: after a jump, nothing
/// in it can be relied on.
[[gnu::noinline]] bool returns(void (*step)(void*), void* top) {
  if (__builtin_setjmp(now.way_out)) return false;
  now.inside = 1;
  step(top);
  now.inside = 0;
  return true;
}

}  // namespace

void leave_rtl(int number) {
  if (!now.inside) return;
  now.inside = 0;
  sigset_t handled;
  sigemptyset(&handled);
  sigaddset(&handled, number);
  sigprocmask(SIG_UNBLOCK, &handled, nullptr);
  now.left_by = number;
  const auto clock = static_cast<unsigned long long>(now.clock);
  if (number == Stuck || number == SIGALRM)
    std::snprintf(last_words.text, sizeof last_words.text,
                  "racebeam: the RTL of %s does not return from clock %llu\n", now.unit, clock);
  else
    std::snprintf(last_words.text, sizeof last_words.text,
                  "racebeam: the RTL of %s crashed in clock %llu: %s\n", now.unit, clock,
                  sigdescr_np(number));
  set(last_words.timer, Patience, false);
  __builtin_longjmp(now.way_out, 1);
}

RtlListener::RtlListener(std::function<bool(const std::string&)> takes) {
  listener = std::move(takes);
}
RtlListener::~RtlListener() { listener = nullptr; }

const rtl_host& rtl_run_host() {
  static const rtl_host host{print, end};
  watch();
  return host;
}

std::uint64_t rtl_evaluations() { return now.number; }

void run_rtl(const rtl_model& model, std::uint64_t clock, void (*step)(void*)) {
  now.model = &model;
  now.unit = model.unit;
  now.clock = clock;
  now.settled = step == model.rise || step == model.rise_and_eval;
  now.number = now.number + 1;
  bool whole = false;
  try {
    whole = returns(step, model.top);
  } catch (const RtlFault&) {
    now.inside = 0;
    throw;
  } catch (const std::exception& error) {
    now.inside = 0;
    throw RtlFault(in_clock() + error.what());
  } catch (...) {
    now.inside = 0;
    throw RtlFault(in_clock() + "an exception of no known type");
  }
  if (whole) return;
  const RtlFault fault = left(now.left_by);
  set(last_words.timer, 0, false);
  throw fault;
}

}  // namespace racebeam
