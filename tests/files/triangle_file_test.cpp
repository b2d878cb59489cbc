#include "files/triangle_file.hpp"

#include "core/text_file.hpp"
#include "files/temporary_folder.hpp"
#include "locale_folder.hpp"

#include <clocale>

namespace pastoso::files {
namespace {

class TriangleFileTest : public TemporaryFolder {};

class OneTriangle final : public TriangleSource {
  public:
    std::string title() const override { return "a triangle, millimetres"; }
    std::size_t vertex_count() const override { return 3; }
    std::size_t triangle_count() const override { return 1; }
    Vector vertex(std::size_t index) const override {
        return {0.25F, 1.0F / 3.0F, -1e-9F * static_cast<float>(index)};
    }
    void for_each_triangle(const std::function<void(const Triangle&)>& use) const override {
        use({0, 1, 2});
    }
};

TEST_F(TriangleFileTest, NumbersAreThoseOfCInEveryLocale) {
    const tests::LocaleFolder locales;
    ASSERT_TRUE(locales.is_whole()) << "needs the package locales";
    const auto obj = [&] {
        write_triangles(folder / "a.obj", OneTriangle(), ObjUp::Z, [](double) { return true; });
        return core::read_text_file(folder / "a.obj");
    };
    const std::string expected =
        "# Pastoso a triangle, millimetres\n"
        "v 0.25 0.333333343 -0\nv 0.25 0.333333343 -9.99999972e-10\nv 0.25 0.333333343 -1.99999994e-09\n"
        "f 1 2 3\n";
    EXPECT_EQ(obj(), expected);
    for (const char* name : tests::LocaleFolder::kNames) {
        ASSERT_NE(std::setlocale(LC_ALL, name), nullptr) << name;
        EXPECT_EQ(obj(), expected) << name;
    }
    std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace pastoso::files
