#!/usr/bin/env bash
# Everything a bare machine needs: system libraries (Debian and its kin), a virtual environment, the locked packages.
set -euo pipefail
cd "$(dirname "$0")/.."

# shared object : Debian package that has it
LIBRARIES="
libusb-1.0.so.0:libusb-1.0-0
libgomp.so.1:libgomp1
libEGL.so.1:libegl1
libGL.so.1:libgl1
libOpenGL.so.0:libopengl0
libX11.so.6:libx11-6
libX11-xcb.so.1:libx11-xcb1
libXrender.so.1:libxrender1
libxkbcommon.so.0:libxkbcommon0
libxkbcommon-x11.so.0:libxkbcommon-x11-0
libdbus-1.so.3:libdbus-1-3
libfontconfig.so.1:libfontconfig1
libglib-2.0.so.0:libglib2.0-0
libSM.so.6:libsm6
libICE.so.6:libice6
libXext.so.6:libxext6
libxcb-cursor.so.0:libxcb-cursor0
libxcb-icccm.so.4:libxcb-icccm4
libxcb-image.so.0:libxcb-image0
libxcb-keysyms.so.1:libxcb-keysyms1
libxcb-randr.so.0:libxcb-randr0
libxcb-render-util.so.0:libxcb-render-util0
libxcb-shape.so.0:libxcb-shape0
libxcb-xinerama.so.0:libxcb-xinerama0
libxcb-xkb.so.1:libxcb-xkb1
"

say() { printf 'setup: %s\n' "$*" >&2; }

missing_packages() {
    local known entry
    known=$(PATH="$PATH:/usr/sbin:/sbin" ldconfig -p)
    for entry in $LIBRARIES; do
        grep -qF "${entry%%:*} " <<<"$known" || printf '%s\n' "${entry##*:}"
    done
    command -v xvfb-run >/dev/null || printf 'xvfb\nxauth\n'
    fc-list 2>/dev/null | grep -q . || printf 'fontconfig\nfonts-dejavu-core\n'
    fc-list :lang=zh-cn 2>/dev/null | grep -q . || printf 'fontconfig\nfonts-wqy-microhei\n'
    command -v xdotool >/dev/null || printf 'xdotool\n'
    python3 -c 'import venv, ensurepip' 2>/dev/null || printf 'python3\npython3-venv\n'
}

install_system_packages() {
    local packages privilege=""
    packages=$(missing_packages | sort -u | tr '\n' ' ')
    [ -n "${packages// /}" ] || return 0
    if ! command -v apt-get >/dev/null; then
        say "these libraries are missing; install what your system calls: $packages"
        exit 1
    fi
    if [ "$(id -u)" -ne 0 ]; then
        if ! sudo -n true 2>/dev/null; then
            say "these libraries are missing; run: sudo apt-get install $packages"
            exit 1
        fi
        privilege="sudo -n"
    fi
    say "installing system libraries: $packages"
    $privilege apt-get update -qq
    # shellcheck disable=SC2086  # the list is meant to be split
    $privilege env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $packages >/dev/null
}

check_python() {
    python3 - <<'PY' || { say "Python 3.11 or 3.12 is needed, found: $(python3 --version 2>&1)"; exit 1; }
import sys
sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 12))
PY
}

install_python_packages() {
    local stamp=.venv/installed
    if [ -f "$stamp" ] && cmp -s "$stamp" <(cat requirements.lock pyproject.toml); then
        return 0
    fi
    [ -x .venv/bin/python ] || python3 -m venv .venv
    say "installing the locked Python packages (about 600 MB to download)"
    .venv/bin/python -m pip install -qq --disable-pip-version-check --require-hashes -r requirements.lock
    .venv/bin/python -m pip install -qq --disable-pip-version-check --no-deps --no-build-isolation -e .
    cat requirements.lock pyproject.toml >"$stamp"
}

install_system_packages
check_python
install_python_packages
