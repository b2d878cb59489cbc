#!/usr/bin/env bash
# Draws the manual's pictures of milk tea into docs/manual/pictures/tea/: the usual glass at eight moments, and a short
# film where there is ffmpeg. What it simulates is kept in out/tea, so that a run that was stopped goes on. Takes some
# minutes.
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
readonly film_s=6 film_fps=15

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
if command -v ffmpeg > /dev/null; then
    say "Drawing the film"
    "$program" tea usual --seconds $film_s --fps $film_fps --frames "$root/out/tea/film" --size 240x240 --samples 32 ||
        fail "a picture of the film is missing; see above."
    ffmpeg -loglevel error -y -framerate $film_fps -i "$root/out/tea/film/milk_%04d.png" -c:v libwebp_anim -loop 0 -quality 70 \
        "$pictures/pour.webp" || fail "ffmpeg could not make the film."
fi
say "$(du -sk "$pictures" | cut -f1) KiB of pictures stand in $pictures"
