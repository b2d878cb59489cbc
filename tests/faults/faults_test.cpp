// A fault here and there in one writer of each kind; faults_long_test tries them all.
#include "faults/sweep.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace pastoso::faults {
namespace {

/// One of each library and of each of our own formats.
const Writer& writer_named(const std::string& name) {
    return *std::find_if(writers().begin(), writers().end(),
                         [&](const Writer& writer) { return writer.name == name; });
}

class DiskFault : public testing::TestWithParam<const char*> {};

TEST_P(DiskFault, LeavesTheOldFileOrTheNewOne) {
    const tests::TemporaryFolder inputs;
    make_inputs(inputs.path());
    const Sweep sweep(writer_named(GetParam()), inputs.path());
    sweep.fail_call(sweep.calls() / 2);
    sweep.fail_call(sweep.calls());
    sweep.fail_behind(sweep.bytes() - 1);
}

INSTANTIATE_TEST_SUITE_P(CommandLine, DiskFault,
                         testing::Values("Export_jpg", "Export_tif", "Replay", "Video_mp4"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace pastoso::faults
