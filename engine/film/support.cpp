#include "film/state.hpp"
