#include "faults/sweep.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::faults {
namespace {

/// Less than a page of the disk, so that each ends in another page; of large files fewer are tried.
constexpr long kStep_bytes = 4000, kMostSteps = 150;

class EveryWriter : public testing::TestWithParam<Writer> {
  protected:
    static void SetUpTestSuite() {
        inputs = new tests::TemporaryFolder;
        make_inputs(inputs->path());
    }
    static void TearDownTestSuite() { delete inputs; }

    static tests::TemporaryFolder* inputs;
};
tests::TemporaryFolder* EveryWriter::inputs = nullptr;

TEST_P(EveryWriter, SurvivesAFaultOfEachCall) {
    const Sweep sweep(GetParam(), inputs->path());
    for (long call = 1; call <= sweep.calls(); ++call)
        sweep.fail_call(call);
}

TEST_P(EveryWriter, SurvivesADiskThatEndsAtEachPage) {
    const Sweep sweep(GetParam(), inputs->path());
    const long step_bytes = std::max(kStep_bytes, sweep.bytes() / kMostSteps);
    for (long bytes = 0; bytes < sweep.bytes(); bytes += step_bytes)
        sweep.fail_behind(bytes);
}

INSTANTIATE_TEST_SUITE_P(CommandLine, EveryWriter, testing::ValuesIn(writers()),
                         [](const auto& chosen) { return chosen.param.name; });

}  // namespace
}  // namespace pastoso::faults
