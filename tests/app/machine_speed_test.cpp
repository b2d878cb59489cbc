// How fine a canvas this machine keeps pace with is measured once.
#include "main/program/machine_speed.hpp"

#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "core/thread_pool.hpp"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

class MachineSpeed : public testing::Test {
  protected:
    MachineSpeed() { ::setenv("XDG_STATE_HOME", folder_.path().c_str(), 1); }
    ~MachineSpeed() override { ::unsetenv("XDG_STATE_HOME"); }

    std::filesystem::path file() const { return folder_.path() / "pastoso" / "machine.json"; }
    void keep(int processors, const std::string& px_per_mm) const {
        std::filesystem::create_directories(file().parent_path());
        core::write_text_file(file(), "{\"version\": 1, \"processors\": " + std::to_string(processors) +
                                          ", \"live_px_per_mm\": " + px_per_mm + "}");
    }

    TemporaryFolder folder_;
    const int processors_ = core::ThreadPool().thread_count();
};

TEST_F(MachineSpeed, IsMeasuredAtTheFirstStartAndKept) {
    const double measured = main::live_px_per_mm();
    EXPECT_THAT(measured, AnyOf(4.0, 6.0, 8.0));
    EXPECT_THAT(core::read_text_file(file()), HasSubstr("\"live_px_per_mm\": "));
    keep(processors_, "5.5");
    EXPECT_EQ(main::live_px_per_mm(), 5.5);
}

TEST_F(MachineSpeed, IsMeasuredAgainOnOtherProcessorsAndWhereTheFileIsDamaged) {
    keep(processors_ + 1, "5.5");
    EXPECT_THAT(main::live_px_per_mm(), AnyOf(4.0, 6.0, 8.0));
    keep(processors_, "1e9");
    EXPECT_THAT(main::live_px_per_mm(), AnyOf(4.0, 6.0, 8.0));
    keep(processors_, "\"fast\"");
    EXPECT_THAT(main::live_px_per_mm(), AnyOf(4.0, 6.0, 8.0));
}

}  // namespace
}  // namespace pastoso::tests
