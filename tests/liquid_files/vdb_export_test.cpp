#include "liquid_files/vdb_export.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

class VdbExportTest : public files::TemporaryFolder {};

TEST_F(VdbExportTest, WritesAVolumeOrSaysThatItCannot) {
    grid::BoxField density({8, 8, 8, 0.01F}), face({8, 8, 8, 0.01F}, 0.5F);
    density.at(3, 4, 5) = 0.25F;
    const VdbFields fields{&density, nullptr, {&face, &face, &face}};
    const auto path = folder / "milk.vdb";
    const std::string complaint = document::error_of([&] { export_vdb(path, fields); });
    if (!has_openvdb()) {
        EXPECT_THAT(complaint,
                    testing::HasSubstr("milk.vdb: cannot be written, since this program was built "
                                       "without OpenVDB."));
        EXPECT_EQ(files_in_folder(), 0U);
        return;
    }
    EXPECT_EQ(complaint, "");
    const std::string file = core::read_text_file(path);
    // The format's magic number, and the grids' names.
    EXPECT_EQ(file.substr(0, 4), " BDV");
    EXPECT_THAT(file, testing::HasSubstr("density"));
    EXPECT_THAT(file, testing::HasSubstr("velocity"));
    EXPECT_THAT(document::error_of([&] { export_vdb(folder / "milk.obj", fields); }),
                testing::HasSubstr("milk.obj: a volume is saved as .vdb"));
}

}  // namespace
}  // namespace pastoso::liquid_files
