# Sourced by the scripts beside it: where the project lies, messages, the list of packages, the build and a virtual display.
# shellcheck shell=bash
set -euo pipefail
unset CDPATH

root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
export root

say() { printf '== %s\n' "$*"; }
fail() {
    printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
    exit 1
}

# Prints the comment at the head of the calling script.
print_help() { sed -n '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"; }

refuse_argument() { fail "there is no option '$1'; --help lists what there is."; }

# What the list has for a group: packages, and groups with an @ before them.
entries_of() { awk -v group="$1" '$1 == group && NF == 2 { print $2 }' "$root/packaging/packages.txt"; }

# The packages of the groups given and of those that they need.
packages_of() {
    local group entry
    for group in "$@"; do
        for entry in $(entries_of "$group"); do
            if [[ $entry == @* ]]; then
                packages_of "${entry#@}"
            else
                printf '%s\n' "$entry"
            fi
        done
    done
}

# build_preset CONFIGURE_PRESET [-DNAME=VALUE...] -- [TARGET...]: no target builds everything.
build_preset() {
    local preset="$1" options=() targets=()
    shift
    while [[ $# -gt 0 && $1 != -- ]]; do
        options+=("$1")
        shift
    done
    shift
    [[ $# -gt 0 ]] && targets=(--target "$@")
    say "Configuring ($preset)"
    (cd "$root" && cmake --preset "$preset" --log-level=WARNING "${options[@]}") ||
        fail "CMake could not configure the build; its message stands above."
    say "Building ($preset)"
    (cd "$root" && NINJA_STATUS='[%f/%t, %e s] ' \
        cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}") ||
        fail "the build failed; the compiler's message stands above."
}

# Starts a virtual X server on a free display number and points the programs started after it there. The
# server ends with the script.
start_virtual_display() {
    display_folder="$(mktemp -d)"
    Xvfb -displayfd 3 -screen 0 1600x1200x24 -noreset -nolisten tcp \
        3>"$display_folder/number" >"$display_folder/log" 2>&1 &
    display_server=$!
    trap stop_virtual_display EXIT
    local waited
    for ((waited = 0; waited < 100; ++waited)); do
        [[ -s $display_folder/number ]] && break
        kill -0 "$display_server" 2>/dev/null || break
        sleep 0.1
    done
    [[ -s $display_folder/number ]] || {
        cat "$display_folder/log" >&2
        fail "the virtual X server (Xvfb) did not start."
    }
    DISPLAY=":$(tr -d '[:space:]' <"$display_folder/number")"
    export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
    unset WAYLAND_DISPLAY XAUTHORITY
}

stop_virtual_display() {
    kill "$display_server" 2>/dev/null || true
    wait "$display_server" 2>/dev/null || true
    rm -rf -- "$display_folder"
}

# Makes a bare Debian, bookworm (12) or another, in the folder "bare", which goes with the script; `inside COMMAND...` runs there.
# For root alone.
make_bare_debian() {
    bare="$(mktemp -d)"
    trap remove_bare_debian EXIT
    say "Making a bare Debian $1 in $bare"
    debootstrap --variant=minbase "$1" "$bare" >"$bare.log" || fail "debootstrap failed; $bare.log tells why."
    rm -f -- "$bare.log"
    mount -t proc proc "$bare/proc"
}

remove_bare_debian() {
    umount "$bare/proc" 2>/dev/null || true
    rm -rf -- "$bare"
}

inside() {
    DEBIAN_FRONTEND=noninteractive PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root XDG_RUNTIME_DIR=/tmp LIBGL_ALWAYS_SOFTWARE=1 \
        chroot "$bare" "$@"
}
