# What scripts/run and scripts/test share: installing packages, configuring and building. Sourced; needs $root.
# shellcheck shell=bash
# Everything said here goes to stderr, so that a program's own output stays its own.
: "${root:?the repository}"

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# Prints "package reason" lines of scripts/packages; with "tests" those of the [tests] part too.
list_packages() {
  awk -v tests="$1" '/^#/ || NF == 0 { next } /^\[tests\]/ { if (tests != "tests") exit; next }
    { package = $1; $1 = ""; print package $0 }' "$root/scripts/packages"
}

# install_packages WHAT: installs what is missing, WHAT being "programs" or "tests".
# A stamp newer than dpkg's database and than the list says that nothing was missing; then nothing is asked.
install_packages() {
  local what=$1 stamp="$root/build/.packages-$1" status=/var/lib/dpkg/status
  [[ $stamp -nt $status && $stamp -nt $root/scripts/packages ]] && return
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "this is no Debian or Ubuntu: install by hand what $root/scripts/packages lists, where it is missing"
    return
  fi

  local installed package reason
  local -a missing=()
  # A package that dpkg never heard of makes it exit with 1: it is missing like the others.
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' 2>/dev/null | awk '$2 == "installed" { print $1 }')
  while read -r package reason; do
    grep -qxF -- "$package" <<<"$installed" && continue
    ((${#missing[@]})) || say "installing through apt:"
    printf '  %-22s %s\n' "$package" "$reason" >&2
    missing+=("$package")
  done < <(list_packages "$what")

  if ((${#missing[@]})); then
    local -a as_root=()
    if ((EUID != 0)); then
      command -v sudo >/dev/null || fail "installing needs root and there is no sudo; as root: apt-get install ${missing[*]}"
      as_root=(sudo)
    fi
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    "${as_root[@]}" apt-get update -q >&2 || say "apt-get update failed; trying with the lists at hand"
    "${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}" >&2 </dev/null ||
      fail "apt could not install: ${missing[*]} (on Ubuntu the 'universe' part must be enabled)"
  fi
  mkdir -p "$root/build"
  touch "$stamp"
}

# build_preset PRESET [TARGET...]: configures where needed and builds; silent when everything is up to date.
# Two callers at once wait for each other.
build_preset() {
  local preset=$1
  local dir="$root/build/$1"
  shift
  command -v cmake >/dev/null || fail "cmake is missing; run without --no-install, or install $root/scripts/packages by hand"
  command -v ninja >/dev/null || fail "ninja is missing; run without --no-install, or install $root/scripts/packages by hand"
  mkdir -p "$root/build"
  (
    flock 9
    if [[ ! -f $dir/build.ninja || $root/CMakePresets.json -nt $dir/build.ninja ]]; then
      say "configuring build/$preset"
      cmake -S "$root" --preset "$preset" >&2 9>&- || exit 1
    fi
    [[ $(ninja -C "$dir" -n "$@" 2>/dev/null | tail -n 1) == "ninja: no work to do." ]] && exit 0
    say "building build/$preset"
    # On a terminal ninja keeps to one line.
    NINJA_STATUS='[%f of %t, %e s] ' ninja -C "$dir" "$@" >&2 9>&-
  ) 9>"$root/build/.lock" || fail "the build failed; its messages are above"
}
