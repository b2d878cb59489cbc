#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors and runs the tests; those of the window
# run on a virtual display.
#
# Usage: packaging/test.sh [--all] [-- CTEST_ARGUMENT...]
#   --all   runs the tests labelled `long` too
#   CTEST_ARGUMENT   handed on to ctest, for example: packaging/test.sh -- -R film
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

selection=(-LE '^long$')
while [[ $# -gt 0 ]]; do
    case "$1" in
        -h | --help) print_help; exit 0 ;;
        --all) selection=() ;;
        --) shift; break ;;
        *) refuse_argument "$1" ;;
    esac
    shift
done

"$root/packaging/build.sh" --tests
start_virtual_display
say "Testing"
if (cd "$root" && ctest --test-dir build/release --output-on-failure -j2 "${selection[@]}" "$@"); then
    say "All tests passed"
else
    fail "tests failed; ctest lists them above."
fi
