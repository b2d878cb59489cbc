// Archives that are written while their contents are still being made.
#include "core/error.hpp"
#include "files/temporary_folder.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::ElementsAre;
using testing::Pair;

class ZipWriterTest : public files::TemporaryFolder {
  protected:
    std::filesystem::path path() const { return folder / "a.zip"; }
    void write(ZipWriter& archive) const {
        core::write_aside(path(), [&](core::OutputFile& file) { archive.write(file); });
    }
    Entries written(ZipWriter& archive) {
        write(archive);
        return entries_of(bytes_in(path()));
    }
};

Bytes bytes_of(const std::string& text) {
    const auto bytes = packing::bytes_of(text);
    return {bytes.begin(), bytes.end()};
}

TEST_F(ZipWriterTest, WaitsForWhatComesLaterAndKeepsTheOrder) {
    std::promise<Bytes> first, third;
    std::thread making;
    ZipWriter archive;
    // Nothing else comes before the archive is being written.
    archive.add("opening", [&] {
        making = std::thread([&] {
            third.set_value(bytes_of("early"));
            first.set_value(bytes_of("late"));
        });
        return std::string("begun");
    });
    archive.add("first", first.get_future());
    archive.add("second", std::string("is there"));
    archive.add("third", third.get_future());
    EXPECT_THAT(written(archive), ElementsAre(Pair("opening", "begun"), Pair("first", "late"),
                                              Pair("second", "is there"), Pair("third", "early")));
    making.join();
}

TEST_F(ZipWriterTest, MakesAContentWhenItsTurnComes) {
    std::vector<std::string> made;
    ZipWriter archive;
    for (const char* name : {"a", "b"})
        archive.add(name, [&made, name] {
            made.emplace_back(name);
            return std::to_string(made.size());
        });
    EXPECT_THAT(written(archive), ElementsAre(Pair("a", "1"), Pair("b", "2")));
    EXPECT_THAT(made, ElementsAre("a", "b"));
}

TEST_F(ZipWriterTest, ThrowsWhatTheMakingThrew) {
    ZipWriter archive;
    archive.add("good", std::string("good"));
    archive.add("bad", []() -> std::string { throw std::length_error("too long"); });
    EXPECT_THROW(write(archive), std::length_error);
    EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(ZipWriterTest, APromiseThatIsNeverKeptIsNoHang) {
    ZipWriter archive;
    {
        std::promise<Bytes> forgotten;
        archive.add("never", forgotten.get_future());
    }
    EXPECT_THROW(write(archive), std::future_error);
}

TEST_F(ZipWriterTest, EmptyAndLargeContentsComeBack) {
    const std::string large(5'000'000, 'x');
    ZipWriter archive;
    archive.add("empty", std::string());
    archive.add("large", [&] { return large; });
    EXPECT_THAT(written(archive), ElementsAre(Pair("empty", ""), Pair("large", large)));
}

}  // namespace
}  // namespace pastoso::project
