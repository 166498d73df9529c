# Sourced: ensure_packages PACKAGE... installs missing packages of Debian.

ensure_packages() {
  missing=
  for package; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q "ok installed" ||
      missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  echo "Installing:$missing"
  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "$0: neither root nor sudo; as root: apt-get install$missing" >&2
      exit 2
    fi
    as_root=sudo
  fi
  log=$(mktemp)
  if ! { $as_root apt-get update && $as_root env DEBIAN_FRONTEND=noninteractive \
         apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "$0: could not install$missing" >&2
    exit 2
  fi
  rm -f "$log"
}

host_packages="cmake ninja-build make g++ libassimp-dev libcli11-dev libexpat1-dev libmeshoptimizer-dev libminizip-dev
  zlib1g-dev liburdfdom-dev nlohmann-json3-dev catch2 python3"
# Clang with its sanitizers; exact rationals for oracles.
test_packages="clang lld libclang-rt-14-dev libgmp-dev"
# The boards need C++ headers, not the library; the RISC-V compiler has none and uses those of Arm.
board_packages="gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-dev qemu-system-arm"
riscv_packages="gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc"
# Stacks, code and bounds from machine code.
measure_packages="python3-pyelftools"
style_packages="clang-format clang-tidy doxygen"
# Compiles 32-bit programs that run on this machine, for the digest that all compilers must produce.
digest_packages="g++-i686-linux-gnu"
# Compiles the WebAssembly of interactive pages.
live_packages="binaryen clang lld wasi-libc libclang-rt-14-dev-wasm32"
# llvm: archives of WebAssembly; conditions that a test has seen.
wasm_packages="$live_packages llvm libc++-14-dev-wasm32 nodejs"
# Shows pages, in long tests.
page_packages="chromium"
# The Python package and its tests.
python_packages="python3-numpy"
# Checks the proofs (tools/prove.sh).
proof_packages="coq gappa cvc5"
