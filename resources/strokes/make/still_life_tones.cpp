#include "still_life_tones.hpp"

namespace pastoso::examples {

const Tones kWallTones = {
    "PB29 PBr7-BU PG18 PW6=0.15",
    "PB29 PG18=0.9 PBr7-BU=0.6 PW6=0.5",
    "PB29=0.8 PG18=0.7 PBr7-BU=0.5 PW6=1.1",
    "PG17=0.7 PB29=0.45 PBr7-BS=0.4 PW6=1.8 PY43=0.3",
    "PG17=0.6 PB36=0.4 PW6=2.6 PY43=0.9 PBr7-BS=0.25",
    "PG17=0.3 PY43 PW6=3.4 PB36=0.2 PBr7-BS=0.1",
};
const Tones kClothTones = {
    "PW6=1.4 PB29=0.8 PBr7-BU=0.4 PV23=0.06",
    "PW6=2.2 PB29=0.6 PBr7-BU=0.22 PV23=0.02",
    "PW6=3.4 PB29=0.42 PY43=0.2 PR101=0.06",
    "PW6=5 PB28=0.35 PY43=0.25 PR101=0.05",
    "PW6=7 PY43=0.4 PB28=0.1",
    "PW6=9 PY43=0.25",
    "PW6=10 PY35=0.08",
};
const Tones kGreenPearTones = {
    "PG17 PBr7-BU PB29=0.4",           "PG17 PY43=0.9 PBr7-BS=0.5", "PY43 PG17=0.6 PY35=0.6",
    "PY35 PG36=0.06 PY43=0.3 PW6=0.4", "PY35 PW6=1.1 PG36=0.03",
};
const Tones kRipePearTones = {
    "PBr7-BU PR83=0.5 PG17=0.5",      "PBr7-BS PY43=0.8 PR108=0.3", "PY43 PO20=0.4 PY35=0.4",
    "PY35 PO20=0.1 PY43=0.3 PW6=0.4", "PY35=0.8 PW6=1.3 PO20=0.03",
};
const Tones kLemonTones = {
    "PBr7-RU PY43=1.6 PB29=0.15", "PY43 PY35=0.5 PG17=0.2", "PY35 PY43=0.3",
    "PY74=0.7 PY35=0.7 PW6=0.25", "PY74=0.7 PW6=1.2",
};
const Tones kAppleTones = {
    "PR83 PB29=0.4 PBr7-BU=0.6", "PR83 PR101=0.6", "PR254 PR101=0.3", "PR108 PO20=0.3",
    "PR108 PO20=0.4 PW6=0.6",
};
const Tones kBowlTones = {
    "PB29 PBr7-BU=0.7 PW6=0.45",     "PB29=0.8 PB28=0.6 PW6=1.1 PBr7-BU=0.35",
    "PW6=2.4 PB28=0.9 PBr7-BU=0.08", "PW6=4.5 PB28=0.6",
    "PW6=7 PB28=0.2 PY43=0.05",      "PW6=9 PY43=0.12",
};
const std::string kContactShadow = "PB29 PBr7-BU=1.2 PR83=0.3 PW6=0.35";

Paints half_mixed(const Tones& tones) {
    Paints paints;
    for (std::size_t i = 0; i < tones.size(); ++i) {
        const std::string& neighbour = tones[i + 1 < tones.size() ? i + 1 : i - 1];
        paints.push_back(load(mixture(tones[i]), mixture(neighbour), 0.22));
    }
    return paints;
}

}  // namespace pastoso::examples
