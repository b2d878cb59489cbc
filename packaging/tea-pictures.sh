#!/usr/bin/env bash
# Draws the manual's pictures of milk tea into docs/manual/pictures/tea/: the usual glass at eight moments. What it
# simulates is kept in out/tea/kept, so that a run that was stopped goes on. Takes some minutes.
#
# Usage: packaging/tea-pictures.sh [--program FILE]
#   --program FILE   a pastoso-cli that is built already; otherwise it is built first
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

program=""
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    --program) [[ $# -eq 2 ]] || fail "--program needs a file after it."; program="$2" ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

readonly tenths=(8 18 50 90 140 240 320 450)  # of a second
readonly fps=5

if [[ -z $program ]]; then
    "$root/packaging/install.sh" build
    build_preset release -- pastoso-cli
    program="$root/build/release/bin/pastoso-cli"
fi
kept="$root/out/tea/kept"
drawn="$root/out/tea/drawn"
pictures="$root/docs/manual/pictures/tea"
say "Pouring 45 seconds of tea"
"$program" tea usual --seconds 45 --fps $fps --cache "$kept" || fail "the tea was not poured to its end; see above."
rm -rf -- "$drawn" "$pictures"
mkdir -p "$drawn" "$pictures"
for tenth in "${tenths[@]}"; do
    frame=$((tenth * fps / 10))
    name="$(printf 'at-%02d-%d-s.png' $((tenth / 10)) $((tenth % 10)))"
    say "Drawing $name"
    "$program" tea render "$kept" --range $frame --frames "$drawn" --size 400x400 || fail "a picture is missing; see above."
    mv -- "$(printf '%s/milk_%04d.png' "$drawn" $frame)" "$pictures/$name"
done
say "$(du -sk "$pictures" | cut -f1) KiB of pictures stand in $pictures"
