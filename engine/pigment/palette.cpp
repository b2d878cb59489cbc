#include "pigment/bands.hpp"
