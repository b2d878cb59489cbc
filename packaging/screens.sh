#!/usr/bin/env bash
# Takes pictures of the program's main states into out/screens/, to be looked at, on a virtual X server.
#
# Usage: packaging/screens.sh [--manual]
#   --manual   puts those that the manual shows into docs/manual/pictures/ as well, and its table of keys
#              into docs/manual/keys.md and translations/keys-*.md
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

manual=no
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    --manual) manual=yes ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

"$root/packaging/install.sh" build run test
build_preset release -DPASTOSO_BUILD_TESTS=ON -- pastoso pastoso-cli pastoso-screens
start_virtual_display
programs="$root/build/release/bin"
screens="$root/out/screens"
rm -rf -- "$screens"
mkdir -p "$screens"
home="$(mktemp -d)"
export HOME="$home" XDG_DATA_HOME="$home" XDG_CONFIG_HOME="$home" XDG_STATE_HOME="$home" XDG_CACHE_HOME="$home"
say "Painting the still life"
"$programs/pastoso-cli" replay "$root/resources/strokes/still-life.json" --save "$home/still-life.pastoso"
say "Taking pictures"
"$programs/pastoso-screens" "$home/still-life.pastoso" "$screens" || fail "some pictures are missing; see above."
rm -rf -- "$home"
if [[ $manual == yes ]]; then
    manual_folder="$root/docs/manual"
    # The pictures that its pages show, and no others.
    rm -f -- "$manual_folder"/pictures/*.png
    for name in $(grep -ho 'pictures/[a-z-]*\.png' "$manual_folder"/*.md | sort -u); do
        cp -- "$screens/$(basename -- "$name")" "$manual_folder/pictures/" || fail "the manual shows a picture that is not taken."
    done
    "$programs/pastoso-screens" --keys en >"$manual_folder/keys.md"
    for language in ja sv zh_TW; do
        "$programs/pastoso-screens" --keys "$language" >"$manual_folder/translations/keys-$language.md"
    done
fi
say "$(find "$screens" -name '*.png' | wc -l) pictures stand in $screens"
