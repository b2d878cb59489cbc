#!/usr/bin/env bash
# Builds with a sanitizer and runs the tests under it: asan (addresses and undefined behaviour, every test) or
# tsan (data races, the tests labelled `threads`).
#
# Usage: packaging/sanitize.sh asan|tsan [CTEST_ARGUMENT...]
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    asan | tsan) preset="$1"; shift ;;
    *) fail "name the sanitizer: asan or tsan." ;;
esac

"$root/packaging/install.sh" build run test
build_preset "$preset" -DPASTOSO_BUILD_TESTS=ON --
start_virtual_display
say "Testing under $preset"
if (cd "$root" && ctest --preset "$preset" -j2 "$@"); then
    say "All tests passed under $preset"
else
    fail "tests failed under $preset; ctest lists them above."
fi
