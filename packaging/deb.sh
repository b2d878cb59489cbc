#!/usr/bin/env bash
# Makes Debian packages of what is committed: pastoso (the window), pastoso-cli, pastoso-doc, libpastoso-dev and
# python3-pastoso (the engine, for programs of others and for Python). The same commit gives the same packages, bit by bit, in any folder.
#
# Usage: packaging/deb.sh [FOLDER]
#   FOLDER   where to build, and to leave the packages; build/packages otherwise
# The environment variable PASTOSO_CMAKE_OPTIONS may hold more options for CMake, such as -DPASTOSO_WEB=ADDRESS.
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

folder="$root/build/packages"
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    -*) refuse_argument "$1" ;;
    "") ;;
    *) folder="$1" ;;
esac

version="$(sed -n 's/^project(Pastoso VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt")"
committed_at="$(git -C "$root" log -1 --format=%ct)" || fail "packages are made of a Git checkout, and this is none."

# The packages of groups of packages.txt, separated by commas.
listed() { packages_of "$@" | sort -u | paste -sd, | sed 's/,/, /g'; }

write_control() {
    sed -e "s/@BUILD_PACKAGES@/$(listed build python book)/" -e "s/@RUN_PACKAGES@/$(listed run)/" \
        -e "s/@ENGINE_PACKAGES@/$(listed engine)/" control.in >control
    rm control.in
}

# The version and the date stand elsewhere already: in CMakeLists.txt, and in the history.
write_changelog() {
    printf 'pastoso (%s) unstable; urgency=medium\n\n  * See /usr/share/doc/pastoso/CHANGELOG.md of pastoso-doc.\n\n' "$version"
    printf ' -- %s  %s\n' "$(sed -n 's/^Maintainer: //p' control)" "$(LC_ALL=C date -u -R -d "@$committed_at")"
} >changelog

"$root/packaging/install.sh" deb
source_folder="$folder/pastoso-$version"
say "Copying the source to $source_folder"
rm -rf -- "$source_folder"
mkdir -p "$source_folder"
git -C "$root" archive HEAD | tar -x -C "$source_folder"
cp -r "$source_folder/packaging/debian" "$source_folder/debian"
(cd "$source_folder/debian" && write_control && write_changelog)
say "Building the packages"
(cd "$source_folder" && dpkg-buildpackage --build=binary --no-sign "-J$(nproc)") ||
    fail "the packages could not be built; the reason stands above."
say "The packages are in $folder:"
(cd "$folder" && ls -l -- *.deb)
