#!/usr/bin/env bash
# package.sh [FOLDER]: does the package of ./dev package work on a machine that has nothing but Debian 12?
#
# Makes a bare Debian 12 root with debootstrap, installs offing_*.deb of FOLDER (default out/package) there with apt,
# draws a picture in an empty folder by the program's name alone, and removes the package again. Fails if installation
# and picture take over two minutes without downloads (OFFING_LONGEST_S: another limit, for a busy machine), or if a
# file stays behind. Then configures the archive of sources on this machine. Needs root, debootstrap, git, 2 GB under
# TMPDIR and a Debian mirror: that of this machine's apt, or OFFING_DEBIAN_MIRROR. Takes about five minutes.
set -euo pipefail

repository=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
packages=${1:-$repository/out/package}
longest_s=${OFFING_LONGEST_S:-120}

source "$repository/tests/fresh/bare_root.sh"

deb=$(compgen -G "$packages/offing_*.deb") || fail "$packages: expected a package, found none" "run ./dev package"
begin_bare_roots "${BASH_SOURCE[0]}" "$packages"
root=$work/root

inside() { in_bare_root "$root" sh -c "export DEBIAN_FRONTEND=noninteractive; $1"; }

# step NAME COMMAND: runs a command in the root; its seconds are in `took_s` afterwards.
step() {
  local user_s system_s TIMEFORMAT='%0R %1U %1S'
  { time inside "$2" >"$work/step.log" 2>&1 || touch "$work/failed"; } 2>"$work/time"
  [[ ! -e "$work/failed" ]] || { tail -n 20 "$work/step.log" >&2; fail "$1 failed" "see above"; }
  read -r took_s user_s system_s <"$work/time"
  say "$1: $took_s s; processor $user_s s, kernel $system_s s"
}

# All that programs and packages may leave, but for what apt and dpkg keep about themselves, and users' own folders.
files() {
  (cd "$root" && find . -xdev \( -path ./var/lib/apt -o -path ./var/lib/dpkg -o -path ./var/cache/apt \
    -o -path ./var/log -o -path ./root -o -path ./tmp \) -prune -o -print | sort)
}

if command -v lintian >/dev/null; then
  lintian --fail-on error "$packages"/*.deb || fail "lintian finds errors" "see above"
else
  say "no lintian here: not checked by it"
fi

make_bare_root bookworm "$root"
mount_system "$root"
cp "$deb" "$root/tmp"
inside 'apt-get -qq update'
before_packages=$(packages_of "$root")
before=$(files)

install="cd /tmp && apt-get -q -y install ./${deb##*/}"
step download "$install --download-only"
step installation "$install"
total_s=$took_s
installed=$(packages_of "$root")
say "$(($(wc -l <<<"$installed") - $(wc -l <<<"$before_packages"))) packages installed"
step picture 'mkdir /tmp/empty && cd /tmp/empty && offing-view world.toml --headless -o x.png && test -s x.png'
total_s=$((total_s + took_s))
step bake 'cd /tmp/empty && offing ocean bake storm.toml --frames 0 --size 64 -o storm && ls storm/*.exr'
step mesh 'cd /tmp/empty && offing-mesh generate sphere -o sphere.obj && offing-mesh check sphere.obj'
((total_s <= longest_s)) || fail "installation and picture took $total_s s" "expected at most $longest_s s"

# Packages that others recommend or suggest count too: those that came with this one.
step removal "apt-get -q -y purge offing && apt-get -q -y autoremove --purge \\
  -o APT::AutoRemove::RecommendsImportant=false -o APT::AutoRemove::SuggestsImportant=false"
diff <(echo "$before_packages") <(packages_of "$root") >&2 || fail "packages stayed" "see above"
left=$(diff <(echo "$before") <(files) || true)
[[ -z "$left" ]] || say "files that came or went: $left"
! grep -qi offing <<<"$left" || fail "files of the package stayed" "see above"

archive=$(compgen -G "$packages/offing-*.tar.gz") || fail "$packages: expected an archive, found none" "run ./dev package"
mkdir "$work/sources"
tar -xf "$archive" -C "$work/sources" --strip-components 1
(cd "$work/sources" && cmake --preset package) >"$work/step.log" 2>&1 ||
  { tail -n 20 "$work/step.log" >&2; fail "$archive cannot be configured" "see above"; }
say "${archive##*/} configures"
say "all passed"
