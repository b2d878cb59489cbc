#!/usr/bin/env bash
# Draws the manual's pictures of the glass tank into docs/manual/pictures/tank/: both scenes that come with the
# program, each at one moment. Takes some minutes.
#
# Usage: packaging/tank-pictures.sh [--program FILE]
#   --program FILE   a pastoso-cli that is built already; otherwise it is built first
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

program=""
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    --program) [[ $# -eq 2 ]] || fail "--program needs a file after it."; program="$2" ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

# Scene, tenths of a second, size.
readonly pictures_of=("falling-liquid 3 640x640" "two-liquids 6 840x560")

if [[ -z $program ]]; then
    "$root/packaging/install.sh" build
    build_preset release -- pastoso-cli
    program="$root/build/release/bin/pastoso-cli"
fi
drawn="$root/out/tank/drawn"
pictures="$root/docs/manual/pictures/tank"
rm -rf -- "$drawn"
mkdir -p "$drawn" "$pictures"
for picture in "${pictures_of[@]}"; do
    read -r scene tenths size <<<"$picture"
    say "Drawing $scene"
    "$program" tank "$scene" --seconds "0.$tenths" --fps 10 --every "$tenths" --size "$size" --samples 48 \
        --frames "$drawn/$scene" || fail "$scene was not drawn; see above."
    mv -- "$(printf '%s/%s/liquid_%04d.png' "$drawn" "$scene" "$tenths")" "$pictures/$scene.png"
done
say "$(du -sk "$pictures" | cut -f1) KiB of pictures stand in $pictures"
