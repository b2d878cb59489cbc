#!/usr/bin/env bash
# Tries the archive that packaging/archive.sh made in bare systems without Qt, Debian 12 and the newer Debian 13: looks for
# the licences of all that it carries, paints an example without a window, opens the window on X11 and on Wayland, draws with
# a pen that presses, and tells which libraries it took from the system. As root; takes some minutes.
#
# Usage: packaging/archive-try.sh [FOLDER]
#   FOLDER   where the archive is; build/packages otherwise
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

folder="$root/build/packages"
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    -*) refuse_argument "$1" ;;
    "") ;;
    *) folder="$1" ;;
esac
archives=("$folder"/pastoso-*-linux-"$(uname -m)".tar.zst)
[[ -f ${archives[0]} ]] || fail "there is no archive in $folder; packaging/archive.sh makes it."
[[ ${#archives[@]} -eq 1 ]] || fail "there are several archives in $folder: ${archives[*]##*/}"
[[ $EUID -eq 0 ]] || fail "only root can make a system of its own."
program="/opt/$(basename -- "${archives[0]}" .tar.zst)/bin"
tablet="$root/build/release/tests/tablet"

# A system with a desktop's graphics drivers, and without Qt. Its pen is that of the tests.
make_system() {
    make_bare_debian "$1"
    inside apt-get -q -y --no-install-recommends install fonts-dejavu-core libegl1 libgl1 libgl1-mesa-dri libopengl0 weston xauth \
        xserver-xorg-core xserver-xorg-video-dummy xvfb >/dev/null || fail "Debian $1 lacks packages; see above."
    inside sh -c 'dpkg -l | grep -i "^ii *libqt" && exit 1 || exit 0' || fail "the bare system has Qt."
    zstd -q -d -c "${archives[0]}" | tar -x -C "$bare/opt"
    cp -r -- "$root/tests/tablet" "$tablet/modules" "$tablet/weston_tablet.so" "$bare/opt/"
}

# Of what the archive carries of others.
check_licences() {
    local archive="$bare${program%/bin}" library package
    say "Looking for licences"
    (cd "$archive" && find lib -name '*.so*' ! -path 'lib/pastoso/*' | sort) >"$bare/tmp/carried"
    [[ -s $bare/tmp/carried ]] || fail "the archive carries no library."
    while read -r library; do
        package="$(awk -v file="$library" '$1 == file { print $2 }' "$archive/licences/README")"
        [[ -n $package && -s $archive/licences/$package ]] || fail "the archive carries $library without its licence."
    done <"$bare/tmp/carried"
}

paint() {
    say "Painting"
    inside "$program/pastoso-cli" --version
    inside "$program/pastoso-cli" replay "$program/../share/pastoso/strokes/sampler.json" --px-per-mm 2 -q -o /tmp/sampler.jpg
}

open_windows() {
    say "Opening the window on X11"
    inside xvfb-run -a -s '-screen 0 1600x1200x24' "$program/pastoso" --screenshot /tmp/x11.png --after 2
    say "Opening the window on Wayland"
    inside /opt/tablet/with_wayland.sh "$program/pastoso" --screenshot /tmp/wayland.png --after 2
    cp -- "$bare/tmp/x11.png" "$folder/x11-$1.png"
    cp -- "$bare/tmp/wayland.png" "$folder/wayland-$1.png"
}

press_pen() {
    say "Drawing with a pen on X11"
    inside /opt/tablet/with_tablet.sh /opt/modules /opt/tablet/pressed_line.sh "$program/pastoso"
    [[ $1 == bookworm ]] || return 0  # the pen's module is one of Weston 10
    say "Drawing with a pen on Wayland"
    inside /opt/tablet/with_wayland.sh --tablet /opt/weston_tablet.so /opt/tablet/pressed_line.sh "$program/pastoso"
}

tell_what_is_taken() {
    say "Taken from the system:"
    inside sh -c "for file in $program/pastoso $program/pastoso-cli $program/../lib/pastoso/*.so; do ldd \$file; done" |
        awk '$3 !~ /^\/opt/ && $2 == "=>" { print $1 }' | sort -u
}

"$root/packaging/install.sh" deb archive test
build_preset ci -DPASTOSO_BUILD_TESTS=ON -- tablet_driver weston_tablet
for system in bookworm trixie; do
    make_system "$system"
    check_licences
    paint
    open_windows "$system"
    press_pen "$system"
    tell_what_is_taken
    remove_bare_debian
done
say "It runs; pictures of it are in $folder"
