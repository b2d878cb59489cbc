#include "core/fault.hpp"

#include "core/error.hpp"
#include "core/message_text.hpp"
#include "core/temporary_folder.hpp"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

TEST(Fault, IsNothingWhereNothingIsThrown) {
    bool done = false;
    EXPECT_EQ(fault_of([&] { done = true; }), "");
    EXPECT_TRUE(done);
}

TEST(Fault, OfBadInputIsItsOwnSentence) {
    EXPECT_EQ(fault_of([] { throw located_error("brush.json", 3, "\"width\" is missing."); }),
              "brush.json, line 3: \"width\" is missing.");
}

TEST(Fault, TellsThatMemoryRanOut) {
    EXPECT_EQ(fault_of([] { throw std::bad_alloc(); }),
              "memory ran out: what was asked for last is not done, or not whole.");
}

TEST(Fault, NamesTheFilesThatTheSystemRefuses) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path missing = folder.path() / "missing";
    EXPECT_EQ(fault_of([&] { std::filesystem::create_directory(missing / "more"); }),
              (missing / "more").string() + ": the system refuses this (No such file or directory).");
    EXPECT_EQ(
        fault_of([&] { std::filesystem::rename(missing, "/tmp/nowhere"); }),
        missing.string() + " and /tmp/nowhere: the system refuses this (No such file or directory).");
    EXPECT_EQ(fault_of([] {
                  throw std::filesystem::filesystem_error(
                      "recursion", std::make_error_code(std::errc::permission_denied));
              }),
              "a file: the system refuses this (Permission denied).");
}

TEST(Fault, TellsTheSystemsReason) {
    EXPECT_EQ(
        fault_of([] {
            throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
        }),
        "the system refuses this (Resource temporarily unavailable).");
}

TEST(Fault, OfTheProgramIsSaidToBeSo) {
    EXPECT_EQ(fault_of([] { throw std::runtime_error("broken pipe"); }),
              "something went wrong within the program (broken pipe).");
    EXPECT_EQ(fault_of([] { throw 7; }),
              "something went wrong within the program (an exception of an unknown kind).");
    EXPECT_EQ(fault_of([] { throw InputError(Message()); }),
              "something went wrong within the program (no reason was given).");
}

TEST(Guarded, TellsOnceAndLetsNothingEscape) {
    std::string told;
    guarded([] { throw InputError("a.png: no picture."); },
            [&](const Message& sentence) { told += sentence.text(); });
    EXPECT_EQ(told, "a.png: no picture.");
    guarded([] {}, [&](const Message& sentence) { told += sentence.text(); });
    EXPECT_EQ(told, "a.png: no picture.");
    guarded([] { throw 7; }, [](const Message&) { throw std::bad_alloc(); });
}

}  // namespace
}  // namespace pastoso::core
