#!/usr/bin/env bash
# Installs what is missing and builds the programs: build/release/bin/pastoso and pastoso-cli.
#
# Usage: packaging/build.sh [--tests]
#   --tests   builds the tests too, and stops at the first compiler warning
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

groups=(build run)
preset=release
targets=(pastoso pastoso-cli)
options=()
# A build folder that holds tests and Python package already keeps them.
[[ -f $root/build/release/CMakeCache.txt ]] || options=(-DPASTOSO_BUILD_TESTS=OFF -DPASTOSO_BUILD_PYTHON=OFF)
for argument in "$@"; do
    case "$argument" in
        -h | --help) print_help; exit 0 ;;
        --tests) groups+=(test); preset=ci; targets=(); options=(-DPASTOSO_BUILD_TESTS=ON -DPASTOSO_BUILD_PYTHON=ON) ;;
        *) refuse_argument "$argument" ;;
    esac
done

"$root/packaging/install.sh" "${groups[@]}"
build_preset "$preset" "${options[@]}" -- "${targets[@]}"
say "Built $root/build/release/bin/pastoso and pastoso-cli"
