#!/usr/bin/env bash
# Runs a program under a Wayland compositor of its own, Weston without a screen.
#
# Usage: with_wayland.sh PROGRAM [ARGUMENT...]
set -euo pipefail

XDG_RUNTIME_DIR="$(mktemp -d)"
export XDG_RUNTIME_DIR
weston --backend=headless-backend.so --socket=wayland-test --width=1600 --height=1200 --idle-time=0 \
    >"$XDG_RUNTIME_DIR/log" 2>&1 &
compositor=$!
stop_compositor() {
    kill "$compositor" 2>/dev/null || true
    wait "$compositor" 2>/dev/null || true
    rm -rf "$XDG_RUNTIME_DIR"
}
trap stop_compositor EXIT
for ((waited = 0; waited < 300; ++waited)); do
    [[ -S $XDG_RUNTIME_DIR/wayland-test ]] && break
    kill -0 "$compositor" 2>/dev/null || break
    sleep 0.1
done
[[ -S $XDG_RUNTIME_DIR/wayland-test ]] || {
    cat "$XDG_RUNTIME_DIR/log" >&2
    echo "with_wayland.sh: Weston did not start." >&2
    exit 1
}
export WAYLAND_DISPLAY=wayland-test LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=wayland
unset DISPLAY
"$@"
