// Sentences that say which file they speak of.
#pragma once

#include "core/error.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace pastoso::core {

/// Calls work() and returns what it does. Where it throws an InputError that does not begin with the
/// file's name, the name is put before it: for work that is given what stands in the file, but not where.
template <class Work>
auto naming(const std::string& file, Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const InputError& error) {
        if (std::string_view(error.what()).starts_with(file)) throw;
        throw InputError("%1: %2", file, error.message());
    }
}

}  // namespace pastoso::core
