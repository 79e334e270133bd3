#pragma once

#include "../support/launched.h"
#include "program.h"

#include <gtest/gtest.h>

#include <string>

namespace cdr::cli_test {

/// Skipped where the program was built without MPI.
class RankTest : public FolderTest {
  protected:
    void SetUp() override {
        if (std::string(CDR_MPIEXEC).empty()) {
            GTEST_SKIP() << "built without MPI (libopenmpi-dev, openmpi-bin)";
        }
    }
};

} // namespace cdr::cli_test
