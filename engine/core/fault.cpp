#include "core/fault.hpp"

#include "core/error.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

namespace pastoso::core {
namespace {

/// For what the program did not foresee.
std::string program_fault(const std::string& what) {
    return "something went wrong within the program (" + what + ").";
}

std::string system_fault(const std::filesystem::filesystem_error& error) {
    std::string files = error.path1().string();
    if (!error.path2().empty()) files += " and " + error.path2().string();
    if (files.empty()) files = "a file";
    return files + ": the system refuses this (" + error.code().message() + ").";
}

std::string sentence_on_caught() {
    try {
        throw;
    } catch (const InputError& error) {
        return error.what();
    } catch (const std::bad_alloc&) {
        return "memory ran out: what was asked for last is not done, or not whole.";
    } catch (const std::filesystem::filesystem_error& error) {
        return system_fault(error);
    } catch (const std::system_error& error) {
        return "the system refuses this (" + error.code().message() + ").";
    } catch (const std::exception& error) {
        return program_fault(error.what());
    } catch (...) {
        return program_fault("an exception of an unknown kind");
    }
}

}  // namespace

std::string caught_fault() noexcept {
    try {
        const std::string sentence = sentence_on_caught();
        return sentence.empty() ? program_fault("no reason was given") : sentence;
    } catch (...) {
        return "Out of memory.";  // short enough to need none
    }
}

}  // namespace pastoso::core
