#!/usr/bin/env bash
# Runs a program under a Wayland compositor of its own, Weston without a screen.
#
# Usage: with_wayland.sh [--tablet MODULE] PROGRAM [ARGUMENT...]
#   MODULE   weston_tablet.so: there is a pen with two ends. The program finds the pipes of both
#            (pen_lines.h) in the folder $PASTOSO_TEST_TABLET, as "pen" and "eraser". Its window covers the
#            screen: programs are not told where others lie.
set -euo pipefail

XDG_RUNTIME_DIR="$(mktemp -d)"
export XDG_RUNTIME_DIR
options=()
awaited=("$XDG_RUNTIME_DIR/wayland-test")
if [[ ${1:-} == --tablet ]]; then
    export PASTOSO_TEST_TABLET="$XDG_RUNTIME_DIR"
    options=(--modules="$2" --shell=kiosk-shell.so)
    awaited+=("$XDG_RUNTIME_DIR/pen" "$XDG_RUNTIME_DIR/eraser")
    shift 2
fi
weston --backend=headless-backend.so --socket=wayland-test --width=1600 --height=1200 --idle-time=0 \
    "${options[@]}" >"$XDG_RUNTIME_DIR/log" 2>&1 &
compositor=$!
stop_compositor() {
    kill "$compositor" 2>/dev/null || true
    wait "$compositor" 2>/dev/null || true
    rm -rf "$XDG_RUNTIME_DIR"
}
trap stop_compositor EXIT
is_ready() {
    local path
    for path in "${awaited[@]}"; do
        [[ -e $path ]] || return 1
    done
}
for ((waited = 0; waited < 300; ++waited)); do
    is_ready && break
    kill -0 "$compositor" 2>/dev/null || break
    sleep 0.1
done
is_ready || {
    cat "$XDG_RUNTIME_DIR/log" >&2
    echo "with_wayland.sh: Weston did not start." >&2
    exit 1
}
export WAYLAND_DISPLAY=wayland-test LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=wayland
unset DISPLAY
"$@"
