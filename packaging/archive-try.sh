#!/usr/bin/env bash
# Tries the archive that packaging/archive.sh made in a bare Debian 12 without Qt: paints an example without a window, opens
# the window on X11 and on Wayland, and tells which libraries it took from the system. As root; takes some minutes.
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
archives=("$folder"/pastoso-*.tar.zst)
[[ -f ${archives[0]} ]] || fail "there is no archive in $folder; packaging/archive.sh makes it."
[[ $EUID -eq 0 ]] || fail "only root can make a system of its own."
"$root/packaging/install.sh" deb archive
make_bare_debian
inside apt-get -q -y --no-install-recommends install fonts-dejavu-core libegl1 libgl1 libgl1-mesa-dri libopengl0 weston xauth xvfb >/dev/null
inside sh -c 'dpkg -l | grep -i "^ii *libqt" && exit 1 || exit 0' || fail "the bare system has Qt."

say "Unpacking"
zstd -q -d -c "${archives[0]}" | tar -x -C "$bare/opt"
program="/opt/$(basename -- "${archives[0]}" .tar.zst)/bin"
say "Painting"
inside "$program/pastoso-cli" --version
inside "$program/pastoso-cli" replay "$program/../share/pastoso/strokes/sampler.json" --px-per-mm 2 -q -o /tmp/sampler.jpg
say "Opening the window on X11"
inside xvfb-run -a -s '-screen 0 1600x1200x24' "$program/pastoso" --screenshot /tmp/x11.png --after 2
say "Opening the window on Wayland"
inside sh -c "weston --backend=headless-backend.so --socket=wayland-try --idle-time=0 >/tmp/weston.log 2>&1 & server=\$!
    sleep 3; WAYLAND_DISPLAY=wayland-try QT_QPA_PLATFORM=wayland $program/pastoso --screenshot /tmp/wayland.png --after 2; answer=\$?
    kill \$server; exit \$answer"
cp -- "$bare"/tmp/{x11,wayland}.png "$folder/"
say "Taken from the system:"
inside sh -c "for file in $program/pastoso $program/pastoso-cli $program/../lib/pastoso/*.so; do ldd \$file; done" | awk '$3 !~ /^\/opt/ && $2 == "=>" { print $1 }' | sort -u
say "It runs; pictures of it are in $folder"
