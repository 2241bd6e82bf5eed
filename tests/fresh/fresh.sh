#!/usr/bin/env bash
# fresh.sh [root|user]...: does ./dev work on a machine that has nothing but Debian 12?
#
# Makes a bare Debian 12 root with debootstrap, clones HEAD into it, and runs `./dev demo` and `./dev test` there
# twice: as root, and in another copy as an ordinary user with sudo (or only as the arguments say). The second
# run of each must install nothing. Prints the time of each run. Needs root, debootstrap, git, about 6 GB under
# TMPDIR and a Debian mirror: that of this machine's apt, or OFFING_DEBIAN_MIRROR. Takes about an hour on 2 cores.
set -euo pipefail

repository=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
people=("$@")
((${#people[@]})) || people=(root user)

source "$repository/tests/fresh/bare_root.sh"

for person in "${people[@]}"; do
  [[ "$person" == root || "$person" == user ]] || fail "fresh.sh: unknown person '$person'" "say root or user"
done
begin_bare_roots "${BASH_SOURCE[0]}" "${people[@]}"

# One commit for all of it, whatever is committed meanwhile.
commit=$(git -c safe.directory='*' -C "$repository" rev-parse HEAD)

make_bare_root bookworm "$work/base"

# inside PERSON COMMAND: runs a shell command in that person's checkout, without terminal or inherited variables.
inside() {
  local person=$1 root="$work/$1" login=root
  [[ "$person" == user ]] && login=visitor
  in_bare_root "$root" su "$login" -c "cd ~/'off ing' && $2"
}

prepare() {
  local person=$1 root="$work/$1" home=/root
  cp -a "$work/base" "$root"
  mount_system "$root"
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

# try PERSON COMMAND first|again: runs ./dev COMMAND, keeps its log, tells its time.
results=()
try() {
  local person=$1 command=$2 time=$3 log="$work/$1-$2-$3.log" before after start=$SECONDS
  before=$(packages_of "$work/$person")
  if ! inside "$person" "./dev $command" >"$log" 2>&1; then
    grep -F -A 25 '***Failed' "$log" >&2 || true
    tail -n 60 "$log" >&2
    fail "as $person: ./dev $command ($time) failed" "the end of its output is above"
  fi
  after=$(packages_of "$work/$person")
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
