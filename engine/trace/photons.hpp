// Light followed forwards, from lamp and sky into the vessel, before a picture is traced (photon
// mapping, Jensen 1996).
#pragma once

#include "trace/caustics.hpp"
#include "trace/fluence_field.hpp"
#include "trace/tracer.hpp"
#include "trace/world.hpp"

#include <functional>
#include <optional>

namespace pastoso::trace {

/// What the photons left. Where there is a field of fluence, it holds all the light in the tea; the
/// caustics, if there are any, hold the lamp's light that comes to the table through or off clear
/// surfaces, and off nothing else.
struct PhotonMaps {
    Caustics caustics;
    FluenceField fluence;
};

/// Sends photons into the vessel: of the lamp, and, where there is milk in a cup, of all else that is
/// around it; as many of each as the picture has pixels, within limits. The same bits on any number of
/// threads. Between batches asks `stop`, if there is one, on any thread of the pool; after a true answer
/// gives none.
std::optional<PhotonMaps> shoot_photons(const World& world, const TraceSettings& settings,
                                        core::ThreadPool& pool, const std::function<bool()>& stop = {});

}  // namespace pastoso::trace
