# Sourced by the other scripts: installs what is missing, configures and builds. Debian 12, as root or with sudo.
# Everything here does nothing, quickly, when it is done already.

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${PERINOX_BUILD_DIR:-$source_dir/build}
configure_options=() # for cmake, besides the build type

# docs/dependencies.md says why each is there.
packages=(
  g++ cmake ninja-build ccache pkg-config
  libopenmpi-dev openmpi-bin trilinos-all-dev libptscotch-dev
  libhdf5-openmpi-dev hdf5-tools
  libeigen3-dev libyaml-cpp-dev libmuparser-dev libfmt-dev libcli11-dev libnanoflann-dev libcairo2-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  gnuplot-nox fonts-dejavu-core
)

say() { printf '\n== %s\n' "$*"; }

stop() {
  printf 'perinox: %s\n' "$*" >&2
  exit 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    stop "these packages are missing and only root may install them: ${missing[*]}; run this as root, or install sudo"
  fi
}

missing_packages() {
  missing=()
  local package status
  declare -A installed=()
  while read -r package status; do
    [ "$status" = installed ] && installed[$package]=yes
  done < <(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null)
  for package in "${packages[@]}"; do
    [ -n "${installed[$package]:-}" ] || missing+=("$package")
  done
}

install_packages() {
  command -v dpkg-query >/dev/null ||
    stop "this is not Debian: install what docs/dependencies.md lists, then: cmake --preset default && cmake --build build"
  missing_packages
  [ ${#missing[@]} -eq 0 ] && return
  say "installing ${#missing[@]} packages: ${missing[*]}"
  # A fresh machine has no package lists; an old one may have lists that no longer fit the mirror.
  if apt-cache policy "${missing[@]}" 2>/dev/null | grep -c 'Candidate: [0-9]' | grep -qx "${#missing[@]}" &&
    as_root apt-get install -y -q --no-install-recommends "${missing[@]}"; then
    return
  fi
  as_root apt-get update -q
  as_root apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# One compiler on a Trilinos header needs up to 3 GB.
parallel_jobs() {
  local cores memory
  cores=$(env -u OMP_NUM_THREADS nproc) # which OMP_NUM_THREADS would lower
  memory=$(awk '/^MemAvailable/ {print int($2 / 3e6)}' /proc/meminfo)
  [ "$memory" -lt 1 ] && memory=1
  echo $((cores < memory ? cores : memory))
}

configure_and_build() {
  local generator=()
  [ -f "$build_dir/CMakeCache.txt" ] || generator=(-G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo)
  say "configuring and building in $build_dir on $(parallel_jobs) cores"
  cmake -S "$source_dir" -B "$build_dir" "${generator[@]}" "${configure_options[@]}" >"$build_dir.log" 2>&1 || {
    cat "$build_dir.log" >&2
    rm -f "$build_dir.log"
    stop "the configuration failed, see above"
  }
  rm -f "$build_dir.log"
  cmake --build "$build_dir" --parallel "$(parallel_jobs)" "$@"
}

# Open MPI: allowed as root, more ranks than cores, quiet in containers, one machine (half of a start is the search for
# networks). One thread a rank.
mpi_environment() {
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
  export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none
  export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
}
