#!/usr/bin/env bash
# toolchain.sh: make `cargo build --target wasm32-unknown-unknown` work.
#
#   eval "$(book/packs/toolchain.sh)"       # stdout = export lines; the log goes to stderr
#   cargo modules
#
# In this order:
#   1. rustc already has the target's std (rustup target add ...): print nothing.
#   2. a std that an earlier run of this script built.
#   3. the standard library's source of exactly this rustc's release, from $WASM_TC_SRC,
#      from rustup's rust-src component, or from Debian's rust-src / rust-web-src where
#      apt offers that release: std is built once, with the installed rustc and cargo,
#      into a private sysroot that is then used with --sysroot.
#   4. Debian's rustc-web with its own source (both from the same build, so they always
#      match; in Debian 12's security suite), unpacked into a private folder: std is built
#      with it, and the wasm build then runs that rustc (RUSTC=...) under the installed cargo.
#
# WASM_TC_DIR     the cache (default ~/.cache/wasm-toolchain: 75 MB for 3., 0.5 GB for 4.)
# WASM_TC_SRC     a library/ folder of this rustc's release that you keep yourself
# WASM_TC_SUITES  further Debian suites to look for 3.'s source in (default: none;
#                 trixie-backports had rust-src 1.95.0 when this was written)
# WASM_TC_ROUTE   src | web: only 3. or only 4. (for tests)
#
# Writes only to $WASM_TC_DIR (and apt's package lists, when they are empty): dpkg's state,
# rustup's toolchains and the project stay as they are. Idempotent; two at a time wait for
# each other. Needs bash, rustc + cargo, and for a download apt-get + dpkg; the crate registry only
# where the source has no library/vendor. Run it in the project's folder, so that its
# rust-toolchain.toml counts. An exported RUSTFLAGS would override the exported variable.
set -euo pipefail

TARGET=wasm32-unknown-unknown
DIR=$(realpath -m "${WASM_TC_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/wasm-toolchain}")
RUSTC0=${RUSTC:-rustc}
# The real binaries behind rustup's proxies: std is built in another folder, where an
# override or a rust-toolchain.toml of the project would not count.
SYS0=$("$RUSTC0" --print sysroot)
if [ -x "$SYS0/bin/rustc" ] && [ -z "${RUSTC:-}" ]; then RUSTC0=$SYS0/bin/rustc; fi
CARGO0=$SYS0/bin/cargo; [ -x "$CARGO0" ] || CARGO0=cargo
HOST=$("$RUSTC0" -vV | sed -n 's/^host: //p')

log() { printf 'toolchain: %s\n' "$*" >&2; }
die() { log "$*"; exit 1; }
release_of() { "$1" -vV | sed -n 's/^release: //p'; }
key_of() { # 1.95.0-59807616e: a std serves one compiler only
  printf '%s-%.9s' "$(release_of "$1")" "$("$1" -vV | sed -n 's/^commit-hash: //p')"
}
has_std() { compgen -G "$1/libstd-*.rlib" >/dev/null && compgen -G "$1/libcore-*.rlib" >/dev/null; }

# ---- 1. the ordinary way -----------------------------------------------------------
installed() { has_std "$("$RUSTC0" --print target-libdir --target $TARGET)"; }
if [ -z "${WASM_TC_ROUTE:-}" ] && installed; then log "target already installed"; exit 0; fi

mkdir -p "$DIR"
exec 9>"$DIR/.lock"; flock 9

emit() { # SYSROOT [RUSTC]
  # TARGET rustflags reach the target's crates only: build scripts and procedural macros
  # keep the installed host std. (A plain RUSTFLAGS variable would override this one.)
  # (The host's tools come with the compiler: rust-lld is found through the link in there.)
  printf 'export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS=%q\n' "--sysroot=$1"
  if [ -n "${2:-}" ]; then printf 'export RUSTC=%q\n' "$2"; fi
  log "ready: ${2:-$RUSTC0} with --sysroot=$1"
  exit 0
}

# ---- Debian packages: apt as it is set up, but nothing gets installed -----------------
APT=() # further apt options
papt() { # apt-get or apt-cache; downloads go to $DIR/apt, and the system's status is only read
  local tool=$1; shift
  mkdir -p "$DIR"/apt/{lists/partial,cache/archives/partial}
  "$tool" -q -o Dir::Cache="$DIR/apt/cache" -o APT::Sandbox::User=root -o Debug::NoLocking=1 \
    -o Acquire::Languages=none -o Acquire::IndexTargets::deb::DEP-11::DefaultEnabled=false \
    "${APT[@]}" "$@"
}
apt_lists() { # a new machine has none
  papt apt-cache show rustc-web >/dev/null 2>&1 || apt-get -q update >&2 || log "apt-get update failed"
}
apt_suites() { # other suites of the same mirror, with lists of their own
  local uri s
  uri=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
    awk '$2 ~ /^[a-z]+$/ && $1 ~ /debian\/$/ { print $1; exit }')
  for s in "$@"; do
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $uri $s main"
  done >"$DIR/apt/sources.list"
  APT=(-o "Dir::Etc::sourcelist=$DIR/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::Lists=$DIR/apt/lists")
  papt apt-get update >&2 || log "apt-get update: some list did not come"
}
find_src_deb() { # RELEASE -> "package=version"
  papt apt-cache madison rust-src rust-web-src 2>/dev/null |
    awk -v r="$1" '{ split($3, v, /[+~-]/); if (v[1] == r) { print $1 "=" $3; exit } }'
}
unpack_library() { # FILE.deb DEST: only library/, 70 MB of the package's 340
  rm -rf "$2.part"; mkdir -p "$2.part"
  dpkg --fsys-tarfile "$1" | tar -x -C "$2.part" --wildcards --strip-components=4 './usr/src/rustc-*/library'
  [ -f "$2.part/library/std/Cargo.toml" ] || die "no library/ in $1"
  rm -rf "$2"; mv "$2.part" "$2"
}

# ---- build std once, and gather its rlibs into a sysroot ------------------------------
build_std() { # RUSTC LIBRARY_DIR SYSROOT
  local rustc=$1 lib=$2 out=$3 w hash
  w=$(mktemp -d "$DIR/build.XXXXXX"); trap "rm -rf '$w'" EXIT; hash=$("$rustc" -vV | sed -n 's/^commit-hash: //p')
  mkdir -p "$w/src"; echo '#![no_std]' >"$w/src/lib.rs"
  cat >"$w/Cargo.toml" <<'E'
[package]
name = "std_seed"
version = "0.0.0"
edition = "2021"
[profile.release]
opt-level = 3
codegen-units = 1
panic = "abort"
debug = false
E
  local vendor=()
  if [ -d "$lib/vendor" ]; then # std's few dependencies: no download at all
    vendor=(--offline --config 'source.crates-io.replace-with="stdvendor"'
      --config "source.stdvendor.directory=\"$lib/vendor\"")
  fi
  # -Cembed-bitcode=yes: object code and bitcode both, so that a project may use lto or not.
  # --remap-path-prefix: the paths in panic messages as in the official std.
  # __CARGO_TESTS_ONLY_SRC_ROOT: where -Zbuild-std finds library/ (cargo's own test hook).
  ( cd "$w"
    unset RUSTC_WRAPPER RUSTC_WORKSPACE_WRAPPER CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET \
      CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS
    RUSTC=$rustc RUSTC_BOOTSTRAP=1 __CARGO_TESTS_ONLY_SRC_ROOT=$lib CARGO_TARGET_DIR=$w/target \
      RUSTFLAGS="-Cembed-bitcode=yes --remap-path-prefix=$lib=/rustc/$hash/library" \
      "$CARGO0" build --release --target $TARGET -Zbuild-std=std,panic_abort "${vendor[@]}" >&2 )
  local dst=$w/sysroot/lib/rustlib/$TARGET/lib
  mkdir -p "$dst"
  find "$w/target/$TARGET/release/deps" -name 'lib*.rlib' ! -name 'libstd_seed-*' -exec cp -t "$dst" {} +
  has_std "$dst" || die "the build left no std"
  # The host's part stays the compiler's own (rust-lld is looked for here, too).
  ln -s "$("$rustc" --print sysroot)/lib/rustlib/$HOST" "$w/sysroot/lib/rustlib/"
  # Smoke test: a real module that uses alloc, float functions and a panic, with fat lto.
  cat >"$w/t.rs" <<'E'
#[no_mangle] pub extern "C" fn f(n: usize) -> f64 { let v: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect(); v[n - 1] }
E
  "$rustc" --sysroot="$w/sysroot" --target $TARGET --crate-type cdylib -O -Clto=fat -Cpanic=abort -o "$w/t.wasm" "$w/t.rs" >&2
  [ "$(head -c4 "$w/t.wasm" | od -An -tx1 | tr -d ' ')" = 0061736d ] || die "the smoke test gave no wasm"
  rm -rf "$out"; mkdir -p "$(dirname "$out")"; mv "$w/sysroot" "$out"; rm -rf "$w"
}

# ---- 2. built earlier --------------------------------------------------------------------
sys=$DIR/sysroot-$(key_of "$RUSTC0"); rel=$(release_of "$RUSTC0")
deb=$DIR/debian-rustc; web=$DIR/rustc-web
web_sys() { echo "$DIR/sysroot-web-$(key_of "$web")"; }
if [ "${WASM_TC_ROUTE:-src}" = src ] && has_std "$sys/lib/rustlib/$TARGET/lib"; then emit "$sys"; fi
if [ "${WASM_TC_ROUTE:-web}" = web ] && [ -x "$web" ] && has_std "$(web_sys)/lib/rustlib/$TARGET/lib"; then
  emit "$(web_sys)" "$web"
fi

# ---- 3. the installed rustc with its own release's source -------------------------------
if [ "${WASM_TC_ROUTE:-src}" = src ]; then
  lib=${WASM_TC_SRC:-$SYS0/lib/rustlib/src/rust/library}
  if [ ! -f "$lib/std/Cargo.toml" ]; then
    lib=$DIR/rust-src-$rel/library
    if [ ! -f "$lib/std/Cargo.toml" ]; then
      log "looking for Debian's rust-src $rel"
      apt_lists
      pkg=$(find_src_deb "$rel")
      if [ -z "$pkg" ] && [ -n "${WASM_TC_SUITES:-}" ]; then
        apt_suites $WASM_TC_SUITES
        pkg=$(find_src_deb "$rel")
      fi
      if [ -n "$pkg" ]; then
        log "downloading $pkg"
        mkdir -p "$DIR/debs"; ( cd "$DIR/debs" && papt apt-get download "$pkg" >&2 )
        unpack_library "$(ls "$DIR"/debs/"${pkg%%=*}_$rel"*.deb | head -1)" "$DIR/rust-src-$rel"
      fi
      rm -rf "$DIR/apt" "$DIR/debs"; APT=()
    fi
  fi
  if [ -f "$lib/std/Cargo.toml" ]; then
    log "building std for $TARGET from $lib"
    build_std "$RUSTC0" "$lib" "$sys"
    rm -rf "$DIR/rust-src-$rel"
    emit "$sys"
  fi
  log "no source for rustc $rel at hand"
  [ "${WASM_TC_ROUTE:-}" != src ] || exit 1
fi

# ---- 4. Debian's rustc-web, private ----------------------------------------------------
if [ ! -d "$DIR/rust-web-src/library" ]; then rm -f "$web"; fi # a run was cut short: anew
if [ ! -x "$web" ]; then
  log "downloading Debian's rustc-web and its source"
  rm -rf "$DIR/apt"; apt_lists
  # apt resolves what this system lacks (libllvm, ...) and only downloads it.
  llvm=$(papt apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks --no-replaces --no-enhances rustc-web |
    sed -n 's/^libllvm\([0-9]*\)$/\1/p' | sort -n | tail -1)
  papt apt-get install -y --no-install-recommends --download-only rustc-web rust-web-src "lld-$llvm" >&2
  rm -rf "$deb" "$deb.part"; mkdir -p "$deb.part"
  for f in "$DIR"/apt/cache/archives/*.deb; do
    case $f in
      */rust-web-src_*) unpack_library "$f" "$DIR/rust-web-src" ;;
      *) dpkg -x "$f" "$deb.part" ;;
    esac
  done
  mkdir -p "$deb.part/usr/lib/rustlib/$HOST/bin"
  # Debian's rustc looks for `rust-lld`, which Debian does not ship: its lld under that name.
  ln -s "../../../llvm-$llvm/bin/lld" "$deb.part/usr/lib/rustlib/$HOST/bin/rust-lld"
  mv "$deb.part" "$deb"; rm -rf "$DIR/apt"
  printf '#!/bin/sh\nLD_LIBRARY_PATH=%s${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}\nexport LD_LIBRARY_PATH\nexec %s "$@"\n' \
    "$(echo "$deb"/usr/lib/*-linux-gnu)" "$deb/usr/bin/rustc" >"$web.part"
  chmod +x "$web.part"; mv "$web.part" "$web"
fi
log "building std for $TARGET with $("$web" -V)"
build_std "$web" "$DIR/rust-web-src/library" "$(web_sys)"
rm -rf "$DIR/rust-web-src"
emit "$(web_sys)" "$web"
