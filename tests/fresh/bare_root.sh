# What the scripts of this folder share: a bare Debian root, made with debootstrap, in which they run commands.
# Sourced. Sets `work`, a folder that goes away with the script.

fail() {  # fail MESSAGE HINT
  printf 'error: %s\nhint: %s\n' "$1" "$2" >&2
  exit 1
}

# begin_bare_roots SCRIPT ARGUMENT...: starts the script again in a mount namespace of its own, so that every mount
# goes with the process, however it ends; then makes `work`.
begin_bare_roots() {
  local tool
  ((EUID == 0)) || fail "${1##*/} makes a root folder and mounts into it" "run it as root"
  for tool in debootstrap git; do
    command -v "$tool" >/dev/null || fail "${1##*/} needs $tool" "apt-get install $tool"
  done
  if [[ -z "${OFFING_FRESH_NAMESPACE:-}" ]]; then
    OFFING_FRESH_NAMESPACE=1 exec unshare --mount --propagation private bash "$@"
  fi
  work=$(mktemp -d --tmpdir offing-fresh.XXXXXX)
  trap remove_bare_roots EXIT
}

remove_bare_roots() {
  local root folder
  for root in "$work"/*/; do
    for folder in sys dev proc; do
      if mountpoint -q "$root$folder"; then umount --lazy --recursive "$root$folder"; fi
    done
  done
  rm -rf --one-file-system "$work"
}

say() { printf 'fresh: %s\n' "$*"; }

# make_bare_root RELEASE FOLDER
make_bare_root() {
  local release=$1 folder=$2 mirror
  mirror=${OFFING_DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Identifier: Packages' \
    "Codename: $release" 2>/dev/null | head -n 1)}
  [[ -n "$mirror" ]] || fail "apt knows no Debian $release mirror" "apt-get update, or set OFFING_DEBIAN_MIRROR"
  say "Debian $release from its mirror, in $folder"
  debootstrap --variant=minbase "$release" "$folder" "$mirror" >"$work/debootstrap.log" 2>&1 ||
    { tail -n 20 "$work/debootstrap.log" >&2; fail "debootstrap failed" "see above; check the mirror"; }
  # Proxies, timeouts and the like of this machine's apt.
  apt-config dump Acquire >"$folder/etc/apt/apt.conf.d/99host"
}

# mount_system FOLDER: what programs in the root expect of a running system.
mount_system() {
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  mount --rbind --read-only /sys "$1/sys"
}

# in_bare_root FOLDER COMMAND ARGUMENT...: without terminal or inherited variables.
in_bare_root() {
  local root=$1
  shift
  chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb HOME=/root \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "$@" </dev/null
}

packages_of() { in_bare_root "$1" dpkg-query -W | sort; }
