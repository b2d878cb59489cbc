#!/usr/bin/env bash
# Installs what is missing, builds Pastoso and opens it with a canvas on the easel. Without a display it replays
# the still life that comes with the program instead and writes out/first-light.png.
#
# Usage: packaging/run.sh [FILE] [-- ARGUMENT...]
#   FILE       a painting, picture or recording to open in the window
#   ARGUMENT   handed on to build/release/bin/pastoso as well (its own help: packaging/run.sh -- --help)
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

file=()
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    "" | --) ;;
    -*) refuse_argument "$1" ;;
    *) [[ -r "$1" ]] || fail "there is no file '$1' to open."; file=("$1"); shift ;;
esac
case "${1-}" in
    "") ;;
    --) shift ;;
    *) refuse_argument "$1" ;;
esac

replay_example() {
    local picture="$root/out/first-light.png"
    say "Painting the example recording into a picture instead."
    mkdir -p "$root/out"
    "$root/build/release/bin/pastoso-cli" replay "$root/resources/strokes/still-life.json" -o "$picture"
    say "Painted $picture"
}

# Opens the window; fails with the words of its error stream in the file given.
open_window() {
    local messages="$1"
    shift
    { "$root/build/release/bin/pastoso" "$@" 2>&1 >&3 | tee "$messages" >&2; } 3>&1
}

"$root/packaging/build.sh"
messages="$(mktemp)"
trap 'rm -f -- "$messages"' EXIT
say "Opening Pastoso"
if open_window "$messages" "${file[@]}" "$@"; then
    say "Pastoso has closed"
elif grep -q "no display" "$messages"; then
    replay_example
else
    fail "Pastoso could not go on; its message stands above."
fi
