// On what the tests of the sphere tracer's units run: the models; with RTL at hand, both twins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

namespace racebeam {

template <class Unit>
using sphere_twins = testing::Types<Unit>;

}  // namespace racebeam
