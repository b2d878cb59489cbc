#!/usr/bin/env bash
# Installs the Debian packages of packages.txt that are missing; does nothing when all are there.
#
# Usage: packaging/install.sh [GROUP...]
#   GROUP   engine, build, run, python, test, bench, fuzz, book, archive or deb, with the groups that it needs; without one: build and run
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

groups=()
for argument in "$@"; do
    case "$argument" in
        -h | --help) print_help; exit 0 ;;
        engine | build | run | python | test | bench | fuzz | book | archive | deb) groups+=("$argument") ;;
        *) refuse_argument "$argument" ;;
    esac
done
[[ ${#groups[@]} -gt 0 ]] || groups=(build run)

# Those of the packages given that are not installed.
missing_among() {
    comm -23 <(printf '%s\n' "$@" | sort -u) \
        <({ dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true; } |
            sed -n 's/^installed //p' | sort -u)
}

as_root() {
    if [[ $EUID -eq 0 ]]; then
        "$@"
    else
        sudo "$@"
    fi
}

install_packages() {
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
    say "Reading the package lists"
    as_root "${apt[@]}" -q update || say "Some package lists could not be read; going on with those there are."
    say "Installing $# packages and what they need: $*"
    as_root "${apt[@]}" -q -y --no-install-recommends install "$@" ||
        fail "apt-get could not install the packages; its message stands above."
}

command -v apt-get >/dev/null ||
    fail "this system has no apt-get; on Debian 12 the script installs what packaging/packages.txt lists."
mapfile -t wanted < <(packages_of "${groups[@]}" | sort -u)
mapfile -t missing < <(missing_among "${wanted[@]}")
if [[ ${#missing[@]} -eq 0 ]]; then
    say "All ${#wanted[@]} packages are installed"
    exit 0
fi
[[ $EUID -eq 0 ]] || command -v sudo >/dev/null ||
    fail "these packages are missing, and installing them takes root or sudo: ${missing[*]}"
install_packages "${missing[@]}"
