// Krita opens a project file as a picture, where Krita is installed.
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "project/paintings.hpp"
#include "shade/render.hpp"

#include <cmath>
#include <cstdlib>

namespace pastoso::project {
namespace {

class WithKrita : public files::TemporaryFolder {};

bool is_installed(const char* program) {
    return std::system(("command -v " + std::string(program) + " > /dev/null").c_str()) == 0;
}

TEST_F(WithKrita, ItsExportShowsThePicture) {
    if (!is_installed("krita") || !is_installed("xvfb-run"))
        GTEST_SKIP() << "krita or xvfb-run is not installed";
    core::ThreadPool pool(2);
    const Project project = busy_project(pool);
    save_project(folder / "a.pastoso", project, pool);
    // Krita goes by the name's ending.
    std::filesystem::copy_file(folder / "a.pastoso", folder / "a.ora");
    const std::string command = "xvfb-run -a krita --export --export-filename '" +
                                (folder / "a.png").string() + "' '" + (folder / "a.ora").string() +
                                "' > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const pigment::LinearImage seen = files::read_colour_image(folder / "a.png");
    shade::RenderSettings settings;
    const film::FilmState& film = project.painting.value.film;
    const pigment::LinearImage own =
        shade::render(film, document::kPrimedGround, film.shape.cells(), settings, pool);
    ASSERT_EQ(seen.width, own.width);
    ASSERT_EQ(seen.height, own.height);
    const pigment::Image8 seen8 = pigment::encode_srgb8(seen), own8 = pigment::encode_srgb8(own);
    for (std::size_t i = 0; i < own8.rgb.size(); ++i)
        ASSERT_LE(std::abs(int{seen8.rgb[i]} - int{own8.rgb[i]}),
                  2);  // it keeps eight bits, and so do we
}

}  // namespace
}  // namespace pastoso::project
