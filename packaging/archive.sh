#!/usr/bin/env bash
# Makes one archive that runs where nothing of Pastoso's is installed, with its own Qt: unpack it and start bin/pastoso. It
# takes from the system the C and C++ libraries, the graphics drivers and what these use, and fonts (docs/packaging.md).
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

add_plugins() {
    local plugin from
    from="$(qmake6 -query QT_INSTALL_PLUGINS)"
    for plugin in "${plugins[@]}"; do
        [[ -e $from/$plugin ]] || fail "there is no $from/$plugin; it is what Qt opens windows and pictures with."
        mkdir -p "$tree/lib/qt6/plugins/$(dirname -- "$plugin")"
        cp -r -- "$from/$plugin" "$tree/lib/qt6/plugins/$(dirname -- "$plugin")/"
    done
    mkdir -p "$tree/share/qt6"
    cp -r -- "$(qmake6 -query QT_INSTALL_TRANSLATIONS)" "$tree/share/qt6/translations"
    printf '[Paths]\nPrefix=..\nPlugins=lib/qt6/plugins\nTranslations=share/qt6/translations\n' >"$tree/bin/qt.conf"
}

programs_and_plugins() { find "$tree/bin" "$tree/lib" -type f \( -name '*.so*' -o -path '*/bin/*' \) -exec sh -c 'head -c 4 "$1" | grep -q ELF && printf "%s\n" "$1"' _ {} \;; }

add_libraries() {
    local file library
    for file in $(programs_and_plugins); do libraries_of "$file"; done | sort -u | while read -r library; do
        cp -L -- "$library" "$tree/lib/"
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
say "Gathering"
for component in cli window; do
    cmake --install "$built" --component "$component" --prefix "$tree" --strip >"$scratch/log" || fail "cmake --install failed: $(cat "$scratch/log")"
done
add_plugins
add_libraries
find_libraries_beside
check_versions
say "Packing; it needs nothing newer than ${newest_needed[*]}"
mkdir -p "$folder"
tar --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$(git -C "$root" log -1 --format=%ct)" -C "$scratch" -c "$name" |
    zstd -q -T0 -19 -f -o "$folder/$name.tar.zst"
say "$folder/$name.tar.zst: $(stat -c %s "$folder/$name.tar.zst") bytes, $(du -sk "$tree" | cut -f1) KiB unpacked"
