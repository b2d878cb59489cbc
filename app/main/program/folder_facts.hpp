// Where the program keeps what is the painter's, and where its own data lie.
#pragma once

#include "main/program/machine_facts.hpp"

namespace pastoso::main {

/// Folders that are not there yet as well.
Facts folder_facts();

}  // namespace pastoso::main
