// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/guarded.h"

#include <new>
#include <string>

#include "sc/swap/rtl_library.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"

namespace racebeam {

int guarded(const std::function<int()>& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    tell(error.what());
    return ExitUsage;
  } catch (const RtlError& error) {
    tell(error.what());
    return interrupted() ? ExitInterrupted : ExitUsage;
  } catch (const ClosedPipe&) {
    return ExitPipe;
  } catch (const OutputError& error) {
    tell(error.what());
    tell("choose another place, or free some space");
    return ExitUsage;
  } catch (const MissingTool& error) {
    tell(error.what());
    return ExitMissing;
  } catch (const Interrupted&) {
    return ExitInterrupted;
  } catch (const std::bad_alloc&) {
    tell("out of memory; render fewer frames at a time");
    return ExitMissing;
  } catch (const SyncError& error) {
    tell(error.what());
    return ExitDifference;
  } catch (const std::exception& error) {
    tell(std::string("internal error, please report: ") + error.what());
    return ExitDifference;
  }
}

}  // namespace racebeam
