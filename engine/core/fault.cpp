#include "core/fault.hpp"

#include "core/error.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

namespace pastoso::core {
namespace {

/// For what the program did not foresee.
template <class What>
Message program_fault(const What& what) {
    return message("something went wrong within the program (%1).", what);
}

Message files_of(const std::filesystem::filesystem_error& error) {
    if (error.path1().empty()) return message("a file");
    if (error.path2().empty()) return Message::verbatim(error.path1().string());
    return message("%1 and %2", error.path1().string(), error.path2().string());
}

Message sentence_on_caught() {
    try {
        throw;
    } catch (const InputError& error) {
        return error.message();
    } catch (const std::bad_alloc&) {
        return message("memory ran out: what was asked for last is not done, or not whole.");
    } catch (const std::filesystem::filesystem_error& error) {
        return message("%1: the system refuses this (%2).", files_of(error), error.code().message());
    } catch (const std::system_error& error) {
        return message("the system refuses this (%1).", error.code().message());
    } catch (const std::exception& error) {
        return program_fault(error.what());
    } catch (...) {
        return program_fault(message("an exception of an unknown kind"));
    }
}

}  // namespace

Message caught_fault() noexcept {
    try {
        Message sentence = sentence_on_caught();
        return sentence.empty() ? program_fault(message("no reason was given")) : sentence;
    } catch (...) {
        return {"Out of memory.", {}};  // short enough to need none
    }
}

}  // namespace pastoso::core
