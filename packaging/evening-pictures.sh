#!/usr/bin/env bash
# Paints the manual's pictures of the evening by a river into docs/manual/pictures/evening/: the state after each step
# of the example. Takes some minutes.
#
# Usage: packaging/evening-pictures.sh [--program FILE]
#   --program FILE   a pastoso-cli that is built already; otherwise it is built first
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

program=""
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    --program) [[ $# -eq 2 ]] || fail "--program needs a file after it."; program="$2" ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

readonly steps=(ground wash blocking-in wet-in-wet knife scumble glaze)
readonly per_s=0.0416666666667  # a step lasts 24 s: kEveningStep_s in resources/strokes/make/scenes.hpp

if [[ -z $program ]]; then
    "$root/packaging/install.sh" build
    build_preset release -- pastoso-cli
    program="$root/build/release/bin/pastoso-cli"
fi
recording="$root/resources/strokes/evening.json"
pictures="$root/docs/manual/pictures/evening"
drawn="$(mktemp -d)"
say "Painting the evening"
"$program" replay "$recording" --quiet --px-per-mm 8 --scale 0.5 --frames "$drawn" --fps $per_s -o "$drawn/end.png" ||
    fail "the evening was not painted to its end; see above."
rm -rf -- "$pictures"
mkdir -p "$pictures"
for number in "${!steps[@]}"; do
    # The first frame is the bare canvas.
    frame="$(printf '%s/frame-%05d.png' "$drawn" $((number + 2)))"
    mv -- "$frame" "$pictures/$((number + 1))-${steps[$number]}.png" || fail "a picture is missing; see above."
done
rm -rf -- "$drawn"
say "$(du -sk "$pictures" | cut -f1) KiB of pictures stand in $pictures"
