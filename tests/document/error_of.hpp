#pragma once

#include "core/error.hpp"

#include <string>

namespace pastoso::document {

/// The sentence of the InputError that `work` throws; empty when it throws none.
template <class Work>
std::string error_of(Work&& work) {
    try {
        work();
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace pastoso::document
