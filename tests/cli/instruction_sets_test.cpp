// A processor that lacks a set runs the widest it has instead.
#include "cli/liquid_test.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

namespace pastoso::cli {
namespace {

using Arguments = std::vector<std::string>;

class CliInstructionSets : public LiquidTest {
  protected:
    /// The command's figures and all files that it makes are the same with every set.
    void expect_the_same(const Arguments& command, const std::string& extension) const {
        for (const char* isa : {"baseline", "avx2", "avx512"}) {
            Arguments arguments = command;
            arguments.insert(arguments.end(), {"-q", "--threads", "2", "--frames", path(isa), "--format",
                                               extension, "--stats", path(std::string(isa) + ".json")});
            ::setenv("PASTOSO_ISA", isa, 1);
            const RunResult run = run_cli(arguments);
            ::unsetenv("PASTOSO_ISA");
            ASSERT_EQ(run.status, 0) << run.errors;
        }
        int compared = 0;
        for (const std::string isa : {"avx2", "avx512"}) {
            EXPECT_EQ(json(isa + ".json").at("state_hash"), json("baseline.json").at("state_hash"));
            for (const std::string& name : files_in("baseline")) {
                if (!name.ends_with("." + extension)) continue;
                EXPECT_EQ(bytes(isa + "/" + name), bytes("baseline/" + name)) << isa << ", " << name;
                ++compared;
            }
        }
        EXPECT_GT(compared, 0);
        for (const char* isa : {"baseline", "avx2", "avx512"})
            std::filesystem::remove_all(path(isa));
    }

    /// Milky liquid falls over a body.
    std::string dam() const {
        return write("dam.json",
                     R"({"format": "pastoso-tank", "version": 1, "cells": [12, 12, 12],
                         "cell_m": 0.08333333333,
                         "liquids": [{"shape": {"block": {"low_m": [-1, -1, -1], "high_m": [0.5, 2, 0.5]}},
                                      "milk": 0.1}],
                         "solids": [{"sphere": {"centre_m": [0.75, 0.5, 0], "radius_m": 0.15}}]})");
    }
};

TEST_F(CliInstructionSets, GiveTheSameTanksAndPicturesOfThem) {
    for (const char* method : {"particles", "level_set", "upwind_level_set", "particle_level_set"}) {
        SCOPED_TRACE(method);
        expect_the_same({"tank", dam(), "--method", method, "--seconds", "0.2", "--every", "6", "--size",
                         "72x54", "--samples", "4"},
                        "png");
        expect_the_same({"tank", dam(), "--method", method, "--seconds", "0.2", "--every", "6"}, "stl");
    }
}

TEST_F(CliInstructionSets, GiveTheSameTeaAndPicturesOfIt) {
    // One picture: photons cost more than all the rest, and it has the milk of every frame before it.
    expect_the_same({"tea", "--grid", "16", "--seconds", "0.6", "--every", "18", "--size", "72x54",
                     "--samples", "4"},
                    "png");
    expect_the_same({"tea", "--grid", "16", "--seconds", "0.6", "--every", "6"}, "stl");
    expect_the_same({"tea", "--classic", "--seconds", "0.6", "--every", "6"}, "stl");
    expect_the_same({"tea", "--classic", "--grid", "16", "--seconds", "0.6", "--every", "6"}, "stl");
}

}  // namespace
}  // namespace pastoso::cli
