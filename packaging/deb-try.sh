#!/usr/bin/env bash
# Tries the packages that packaging/deb.sh made, in a bare Debian 12 of their own: checks them with lintian, installs them,
# tells how long it takes to the first stroke, follows the links of the manual, paints an example without and with a window
# and from Python, builds a program with the engine and each part of it alone, removes them, and tells their sizes. As root;
# takes some ten minutes.
#
# Usage: packaging/deb-try.sh [FOLDER]
#   FOLDER   where the packages are; build/packages otherwise
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

folder="$root/build/packages"
case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    -*) refuse_argument "$1" ;;
    "") ;;
    *) folder="$1" ;;
esac
packages=("$folder"/{pastoso{,-cli,-doc},libpastoso-dev,python3-pastoso}_*.deb)
[[ -f ${packages[0]} ]] || fail "there are no packages in $folder; packaging/deb.sh makes them."
[[ $EUID -eq 0 ]] || fail "only root can make a system of its own."
"$root/packaging/install.sh" deb

say "Checking the packages"
lintian --allow-root --fail-on error "${packages[@]}" || fail "lintian has found errors."

make_bare_debian bookworm
cp -- "${packages[@]}" "$bare/tmp/"

# What painters wait for until they paint, once everything is fetched.
install_window() { inside sh -c "apt-get -q -y --no-install-recommends $1 /tmp/pastoso_*.deb /tmp/pastoso-cli_*.deb"; }
say "Installing the window"
install_window "--download-only install" || fail "what the window needs cannot be fetched."
SECONDS=0
install_window install || fail "the window cannot be installed."
installed_s=$SECONDS
inside apt-get -q -y --no-install-recommends install xvfb xauth xdotool >/dev/null
cp -- "$root/packaging/first-stroke.sh" "$bare/tmp/"
say "The first stroke, after $installed_s s of installing:"
inside xvfb-run -a -s '-screen 0 1600x1200x24' /tmp/first-stroke.sh pastoso || fail "what is installed does not paint."

say "Installing the rest"
inside sh -c 'apt-get -q -y --no-install-recommends install /tmp/*.deb' || fail "the packages cannot be installed."
for package in pastoso pastoso-cli pastoso-doc libpastoso-dev python3-pastoso; do
    # shellcheck disable=SC2016  # dpkg-query expands it
    say "$package: $(inside dpkg-query -W -f '${Installed-Size}' "$package") KiB installed, $(stat -c %s "$folder/${package}"_*.deb) bytes packed"
done

say "Checking the manual"
cp -- "$root/packaging/check_pages.py" "$bare/tmp/"
inside python3 /tmp/check_pages.py /usr/share/doc/pastoso/docs/html || fail "pages of the manual lead nowhere; see above."
for translation in en.po "$root"/docs/manual/translations/*.po; do
    language="$(basename -- "$translation" .po)"
    for file in "$language/README.html" "pastoso-$language.pdf"; do
        [[ -f $bare/usr/share/doc/pastoso/docs/html/$file ]] || fail "pastoso-doc lacks $file of the manual."
    done
done

say "Painting"
inside pastoso-cli --version
inside pastoso-cli replay /usr/share/pastoso/strokes/sampler.json --px-per-mm 2 -q -o /tmp/sampler.png
inside xvfb-run -a -s '-screen 0 1600x1200x24' pastoso --screenshot /tmp/window.png --after 2
inside python3 -c 'import pastoso; pastoso.Painting.replay("/usr/share/pastoso/strokes/palette.json").save("/tmp/python.webp")'
inside pastoso-cli replay /usr/share/pastoso/strokes/palette.json -q -o /tmp/replay.webp
cmp -- "$bare/tmp/python.webp" "$bare/tmp/replay.webp" || fail "Python does not paint what pastoso-cli paints."
cp -- "$bare/tmp/sampler.png" "$bare/tmp/window.png" "$folder/"

say "Building a program of others with the engine"
inside apt-get -q -y --no-install-recommends install cmake g++ make >/dev/null
inside cp -r /usr/share/doc/pastoso/example /tmp/example
inside cmake -S /tmp/example -B /tmp/example/build
inside cmake --build /tmp/example/build
inside ctest --test-dir /tmp/example/build --output-on-failure

say "Compiling each header alone, and linking to each library alone"
cp -r -- "$root/packaging/engine_parts" "$bare/tmp/"
inside cmake -S /tmp/engine_parts -B /tmp/engine_parts/build >/dev/null
inside cmake --build /tmp/engine_parts/build --parallel "$(nproc)" >/dev/null ||
    fail "a header or a library needs what it does not bring along; see above."

say "Removing"
inside apt-get -q -y purge pastoso pastoso-cli pastoso-doc libpastoso-dev python3-pastoso
left="$(inside find / -xdev -iname '*pastoso*' -not -path '/proc/*' -not -path '/tmp/*' -not -path '/var/cache/*' -not -path '/root/*')"
[[ -z $left ]] || fail "this was left behind: $left"
say "The packages install, paint and go; pictures of it are in $folder"
