#!/usr/bin/env bash
# Draws the small pictures of the glasses of tea that come with the program, resources/tea/NAME.jpg, by which the window
# shows them. Takes some minutes.
#
# Usage: packaging/tea-recipes.sh [--program FILE]
#   --program FILE   a pastoso-cli that is built already; otherwise it is built first
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

program=""
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    --program) [[ $# -eq 2 ]] || fail "--program needs a file after it."; program="$2" ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

# When each looks most like itself, in tenths of a second.
declare -rA tenths=([usual]=30 [cold-brew]=60 [cream]=50 [drops]=45 [stirred]=70 [cloud]=12)

if [[ -z $program ]]; then
    "$root/packaging/install.sh" build
    build_preset release -- pastoso-cli
    program="$root/build/release/bin/pastoso-cli"
fi
drawn="$root/out/tea/recipes"
rm -rf -- "$drawn"
for scene in "${!tenths[@]}"; do
    tenth="${tenths[$scene]}"
    say "Drawing $scene"
    "$program" tea "$scene" --seconds "$((tenth / 10)).$((tenth % 10))" --fps 10 --every "$tenth" --size 160x160 --samples 96 \
        --format jpg --frames "$drawn/$scene" || fail "a picture is missing; see above."
    mv -- "$(printf '%s/%s/milk_%04d.jpg' "$drawn" "$scene" "$tenth")" "$root/resources/tea/$scene.jpg"
done
say "$(du -ck "$root"/resources/tea/*.jpg | tail -1 | cut -f1) KiB of pictures stand in $root/resources/tea"
