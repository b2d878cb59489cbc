#!/usr/bin/env bash
# Makes one archive that runs where nothing of Pastoso's is installed, with its own Qt: unpack it and start bin/pastoso. It
# takes from the system the C and C++ libraries, the graphics drivers and what these use, and fonts (docs/packaging.md). The
# folder licences holds those of all that it carries of others.
#
# Usage: packaging/archive.sh [FOLDER]
#   FOLDER   where to leave pastoso-VERSION-linux-ARCHITECTURE.tar.zst; build/packages otherwise
# The environment variable PASTOSO_CMAKE_OPTIONS may hold more options for CMake.
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

folder="$root/build/packages"
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    -*) refuse_argument "$1" ;;
    "") ;;
    *) folder="$1" ;;
esac

# What the oldest systems that the archive is for have of the C and C++ libraries, both of spring 2022: Ubuntu 22.04, Fedora 36.
readonly newest_needed=(GLIBC_2.35 GLIBCXX_3.4.30 CXXABI_1.3.13)

# What belongs to the system: the C and C++ libraries, the graphics drivers, and those that both drivers and we use. A driver is
# made for its own system's, a program has each only once, and an older one of ours would lack what a newer driver asks for.
readonly of_c='ld-linux.*|lib(c|m|dl|pthread|rt|resolv|util|nsl|anl|mvec|BrokenLocale|thread_db|nss_.*|stdc\+\+|gcc_s)'
readonly of_drivers='lib(GL|GLX|EGL|OpenGL|GLdispatch|drm.*|gbm|glapi|expat|Xau|Xdmcp|X11|X11-xcb|xcb|xcb-dri[23]|xcb-present|wayland-(client|server))'
readonly of_the_system="^($of_c|$of_drivers)\.so(\..*)?$"

# The libraries that a program or library is linked to, but for the system's.
libraries_of() {
    ldd "$1" | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | while read -r library; do
        [[ $(basename -- "$library") =~ $of_the_system ]] || printf '%s\n' "$library"
    done
}

# What Qt opens by itself: windows, input and decorations on X11 and Wayland, pictures and icons in SVG.
plugins=(iconengines imageformats/libqsvg.so imageformats/libqjpeg.so platforminputcontexts platforms/libqxcb.so
    platforms/libqoffscreen.so platforms/libqwayland-egl.so platforms/libqwayland-generic.so wayland-decoration-client
    wayland-graphics-integration-client wayland-shell-integration xcbglintegrations)

# The package of Debian that a file of the system is of. Some packages know it by where it was before /lib became a part of /usr.
package_of() {
    local file found
    file="$(realpath -- "$1")"
    found="$(dpkg -S "$file" "${file#/usr}" 2>/dev/null | grep -v '^diversion' | head -n 1)" || true
    [[ -n $found ]] || fail "$1 is of no package, so that its licence cannot be found."
    printf '%s\n' "${found%%[:,]*}"
}

# add_licence FILE PLACE: the licence of the package that a file of the system is of, which is at that place in the archive.
add_licence() {
    local package text
    package="$(package_of "$1")" || exit 1
    text="/usr/share/doc/$package/copyright"
    [[ -s $text ]] || fail "$1 is of the package $package, which has no $text."
    cp -L -- "$text" "$tree/licences/$package"
    # shellcheck disable=SC2016  # dpkg-query expands it
    dpkg-query -W -f "$2 $package "'${source:Package} ${source:Version}\n' "$package" >>"$scratch/carried"
}

# carry FILE FOLDER: a file of the system into a folder of the archive, and its licence.
carry() {
    mkdir -p "$tree/$2"
    cp -L -- "$1" "$tree/$2/"
    add_licence "$1" "$2/$(basename -- "$1")"
}

# Of libraries that are no files of the archive, as they are all headers.
add_licences_of_headers() {
    local header
    for header in glm/glm.hpp nlohmann/json.hpp CLI/CLI.hpp; do add_licence "/usr/include/$header" bin; done
}

# With the texts that licences of Debian point to.
write_licences() {
    cp -r -- /usr/share/common-licenses "$tree/licences/"
    cp -- "$root/LICENSE" "$tree/licences/pastoso"
    {
        printf '%s\n' "Pastoso is free software under the licence in the file \"pastoso\". What this archive carries of others is listed below: the" \
            "file, the package of Debian 12 that it was taken from, and the source package with its version. The file of the package's" \
            "name has its licence. Licences that are named there as /usr/share/common-licenses are in common-licenses. All sources are" \
            "at https://snapshot.debian.org." ""
        sort -u "$scratch/carried"
    } >"$tree/licences/README"
}

add_plugins() {
    local plugin from file
    from="$(qmake6 -query QT_INSTALL_PLUGINS)"
    for plugin in "${plugins[@]}"; do
        [[ -e $from/$plugin ]] || fail "there is no $from/$plugin; it is what Qt opens windows and pictures with."
        find "$from/$plugin" -type f | while read -r file; do
            carry "$file" "lib/qt6/plugins/$(realpath --relative-to="$from" "$(dirname -- "$file")")"
        done
    done
    mkdir -p "$tree/share/qt6"
    cp -r -- "$(qmake6 -query QT_INSTALL_TRANSLATIONS)" "$tree/share/qt6/translations"
    add_licence "$(qmake6 -query QT_INSTALL_TRANSLATIONS)/qtbase_ja.qm" share/qt6/translations
    printf '[Paths]\nPrefix=..\nPlugins=lib/qt6/plugins\nTranslations=share/qt6/translations\n' >"$tree/bin/qt.conf"
}

programs_and_plugins() { find "$tree/bin" "$tree/lib" -type f \( -name '*.so*' -o -path '*/bin/*' \) -exec sh -c 'head -c 4 "$1" | grep -q ELF && printf "%s\n" "$1"' _ {} \;; }

add_libraries() {
    local file library
    for file in $(programs_and_plugins); do libraries_of "$file"; done | sort -u | while read -r library; do
        carry "$library" lib
    done
}

# From where it lies to lib.
find_libraries_beside() {
    local file
    for file in $(programs_and_plugins); do
        patchelf --set-rpath "\$ORIGIN/$(realpath --relative-to="$(dirname -- "$file")" "$tree/lib")" "$file"
    done
}

# Lines "VERSION FILE": of the C and C++ libraries' functions that files are linked to.
versions_needed() {
    local file
    for file in $(programs_and_plugins); do
        objdump -p "$file" | sed -nE "s#^.* ((GLIBC|GLIBCXX|CXXABI)_[A-Z0-9_.]+)\$#\1 ${file#"$tree/"}#p"
    done
}

check_versions() {
    local needed newest version file
    needed="$(versions_needed | sort -V)"
    for newest in "${newest_needed[@]}"; do
        read -r version file <<<"$(grep "^${newest%%_*}_" <<<"$needed" | tail -n 1)"
        [[ $(printf '%s\n' "$version" "$newest" | sort -V | tail -n 1) == "$newest" ]] ||
            fail "$file needs $version, and the oldest systems that the archive is for have $newest."
    done
}

built="$root/build/archive"
"$root/packaging/install.sh" build run archive
# shellcheck disable=SC2086  # several options
build_preset archive ${PASTOSO_CMAKE_OPTIONS-} --
name="pastoso-$("$built/bin/pastoso-cli" --version | grep -o '[0-9][0-9.]*')-linux-$(uname -m)"
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
tree="$scratch/$name"
mkdir -p "$tree/licences"
say "Gathering"
for component in cli window; do
    cmake --install "$built" --component "$component" --prefix "$tree" --strip >"$scratch/log" || fail "cmake --install failed: $(cat "$scratch/log")"
done
add_plugins
add_libraries
add_licences_of_headers
write_licences
find_libraries_beside
check_versions
say "Packing; it needs nothing newer than ${newest_needed[*]}"
mkdir -p "$folder"
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git -C "$root" log -1 --format=%ct)" -C "$scratch" -c "$name" |
    zstd -q -T0 -19 -f -o "$folder/$name.tar.zst"
say "$folder/$name.tar.zst: $(stat -c %s "$folder/$name.tar.zst") bytes, $(du -sk "$tree" | cut -f1) KiB unpacked"
