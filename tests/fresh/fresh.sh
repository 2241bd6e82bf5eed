#!/usr/bin/env bash
# fresh.sh [root|user]...: does ./dev work on a machine that has nothing but Debian 12?
#
# Makes a bare Debian 12 root with debootstrap, clones HEAD into it, and runs `./dev demo` and `./dev test` there
# twice: as root, and in another copy as an ordinary user with sudo (or only as the arguments say). The second
# run of each must install nothing. Prints the time of each run. Needs root, debootstrap, git, about 6 GB under
# TMPDIR and a Debian mirror: that of this machine's apt, or OFFING_DEBIAN_MIRROR. Takes about an hour on 2 cores.
set -euo pipefail

repository=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
release=bookworm
people=("$@")
((${#people[@]})) || people=(root user)

fail() {
  printf 'error: %s\nhint: %s\n' "$1" "$2" >&2
  exit 1
}

for person in "${people[@]}"; do
  [[ "$person" == root || "$person" == user ]] || fail "fresh.sh: unknown person '$person'" "say root or user"
done
((EUID == 0)) || fail "fresh.sh makes a root folder and mounts into it" "run it as root"
for tool in debootstrap git; do
  command -v "$tool" >/dev/null || fail "fresh.sh needs $tool" "apt-get install $tool"
done

# In a mount namespace of its own, every mount below goes with this process, however it ends.
if [[ -z "${OFFING_FRESH_NAMESPACE:-}" ]]; then
  OFFING_FRESH_NAMESPACE=1 exec unshare --mount --propagation private bash "${BASH_SOURCE[0]}" "${people[@]}"
fi

mirror=${OFFING_DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Identifier: Packages' \
  "Codename: $release" 2>/dev/null | head -n 1)}
[[ -n "$mirror" ]] || fail "apt knows no Debian $release mirror" "apt-get update, or set OFFING_DEBIAN_MIRROR"

work=$(mktemp -d --tmpdir offing-fresh.XXXXXX)
cleanup() {
  local person folder
  for person in root user; do
    for folder in sys dev proc; do
      if mountpoint -q "$work/$person/$folder"; then umount --lazy --recursive "$work/$person/$folder"; fi
    done
  done
  rm -rf --one-file-system "$work"
}
trap cleanup EXIT

say() { printf 'fresh: %s\n' "$*"; }

# One commit for all of it, whatever is committed meanwhile.
commit=$(git -c safe.directory='*' -C "$repository" rev-parse HEAD)

say "Debian $release from its mirror, in $work"
debootstrap --variant=minbase "$release" "$work/base" "$mirror" >"$work/debootstrap.log" 2>&1 ||
  { tail -n 20 "$work/debootstrap.log" >&2; fail "debootstrap failed" "see above; check the mirror"; }
# Proxies, timeouts and the like of this machine's apt.
apt-config dump Acquire >"$work/base/etc/apt/apt.conf.d/99host"

# inside PERSON COMMAND: runs a shell command in that person's checkout, without terminal or inherited variables.
inside() {
  local person=$1 root="$work/$1" login=root
  [[ "$person" == user ]] && login=visitor
  chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" su "$login" -c "cd ~/'off ing' && $2" </dev/null
}

prepare() {
  local person=$1 root="$work/$1" home=/root
  cp -a "$work/base" "$root"
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --rbind --read-only /sys "$root/sys"
  if [[ "$person" == user ]]; then
    home=/home/visitor
    chroot "$root" sh -c 'apt-get -qq update && apt-get -qq install -y --no-install-recommends sudo' \
      >"$work/sudo.log" 2>&1 || { cat "$work/sudo.log" >&2; fail "sudo could not be installed" "see above"; }
    chroot "$root" useradd --create-home --shell /bin/bash visitor
    echo 'visitor ALL=(ALL) NOPASSWD: ALL' >"$root/etc/sudoers.d/visitor"
  fi
  # A path with a space, as people have.
  git -c safe.directory='*' clone --quiet --no-local "$repository" "$root$home/off ing"
  git -c safe.directory='*' -C "$root$home/off ing" checkout --quiet --detach "$commit"
  [[ "$person" == root ]] || chroot "$root" chown -R visitor: "$home"
}

packages() { chroot "$work/$1" dpkg-query -W | sort; }

# try PERSON COMMAND first|again: runs ./dev COMMAND, keeps its log, tells its time.
results=()
try() {
  local person=$1 command=$2 time=$3 log="$work/$1-$2-$3.log" before after start=$SECONDS
  before=$(packages "$person")
  if ! inside "$person" "./dev $command" >"$log" 2>&1; then
    grep -F -A 25 '***Failed' "$log" >&2 || true
    tail -n 60 "$log" >&2
    fail "as $person: ./dev $command ($time) failed" "the end of its output is above"
  fi
  after=$(packages "$person")
  if [[ "$time" == again && "$before" != "$after" ]]; then
    diff <(echo "$before") <(echo "$after") >&2 || true
    fail "as $person: the second ./dev $command installed packages" "list them in ./dev for the first run"
  fi
  local installed
  installed=$(($(wc -l <<<"$after") - $(wc -l <<<"$before")))
  results+=("$(printf '%-5s ./dev %-5s %-6s %5d s  %3d packages installed' \
    "$person" "$command" "$time" $((SECONDS - start)) "$installed")")
  say "${results[-1]}"
  grep -E 'passed, [0-9]+ failed|^skipped:' "$log" || true
}

for person in "${people[@]}"; do
  prepare "$person"
  # Either command must do as the first: the demo comes first to root, the tests to the user.
  commands=(demo test)
  [[ "$person" == user ]] && commands=(test demo)
  for command in "${commands[@]}"; do
    try "$person" "$command" first
    try "$person" "$command" again
  done
done

say "all passed at $commit, $(nproc) cores"
printf '%s\n' "${results[@]}"
