#!/usr/bin/env bash
# Makes a release of what is committed: runs all checks, builds every package twice and compares them, tries them in bare
# systems, and leaves them in a folder with their sums and what has changed. As root; takes an hour or more.
#
# Usage: packaging/release.sh [FOLDER]
#   FOLDER   where to leave it all; build/release-VERSION otherwise, which must not be there yet
# The environment variable PASTOSO_CMAKE_OPTIONS may hold more options for CMake, such as -DPASTOSO_WEB=ADDRESS.
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

version="$(sed -n 's/^project(Pastoso VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt")"
folder="$root/build/release-$version"
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    -*) refuse_argument "$1" ;;
    "") ;;
    *) folder="$1" ;;
esac
[[ -n $version ]] || fail "CMakeLists.txt does not begin with the version."
[[ $EUID -eq 0 ]] || fail "only root can try packages and archive in systems of their own."
changes="$(git -C "$root" status --porcelain 2>/dev/null)" || fail "a release is made of a Git checkout, and this is none."
[[ -z $changes ]] || fail "there are changes that are not committed: ${changes//$'\n'/,}"
[[ ! -e $folder ]] || fail "$folder is there already; a release is made anew."
grep -q "^## $version" "$root/CHANGELOG.md" || fail "CHANGELOG.md says nothing about $version."
! grep -q "^## $version .*not released" "$root/CHANGELOG.md" || fail "CHANGELOG.md says that $version is not released: give it a date."
date="$(sed -n 's/^set(PASTOSO_VERSION_DATE \([0-9-]*\)).*/\1/p' "$root/CMakeLists.txt")"
grep -q "^## $version .*$date" "$root/CHANGELOG.md" || fail "CHANGELOG.md gives $version another date than CMakeLists.txt does, $date."

scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
say "Running all checks"
"$root/packaging/test.sh"
for time in first second; do
    say "Building the packages, the $time time"
    CCACHE_DISABLE=1 "$root/packaging/deb.sh" "$scratch/$time"
done
for package in "$scratch"/first/*.deb; do
    cmp -- "$package" "$scratch/second/$(basename -- "$package")" || fail "$(basename -- "$package") came out otherwise the second time."
done
"$root/packaging/deb-try.sh" "$scratch/first"
"$root/packaging/archive.sh" "$scratch/first"
"$root/packaging/archive-try.sh" "$scratch/first"

mkdir -p "$folder"
cp -- "$scratch"/first/*.{deb,tar.zst} "$folder/"
git -C "$root" archive --prefix="pastoso-$version/" HEAD | zstd -q -19 -o "$folder/pastoso-$version-source.tar.zst"
awk -v version="$version" '/^## / { in_it = index($0, "## " version) == 1 } in_it' "$root/CHANGELOG.md" >"$folder/CHANGES.md"
(cd "$folder" && sha256sum -- *.deb *.tar.zst CHANGES.md >SHA256SUMS)
say "Release $version is in $folder"
