#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# carried.sh BUILD CMAKE CPACK: the program of the archive needs the C library alone, and works where nothing else of ours is.
set -eu
build=$1 cmake=$2 cpack=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$cmake" --build "$build" --target touchstone_alone manual >"$folder/log" 2>&1 || { cat "$folder/log" && exit 1; }
"$cpack" --config "$build/CPackConfig.cmake" -G TGZ -B "$folder" >"$folder/log" 2>&1 || { cat "$folder/log" && exit 1; }
if command -v dpkg-deb >/dev/null; then  # the newest symbol that it takes from the C library, read in another way
  "$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$folder" >"$folder/log" 2>&1 || { cat "$folder/log" && exit 1; }
  newest=$(readelf --version-info "$build/alone/touchstone" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1)
  [ "$(dpkg-deb -f "$folder"/touchstone_*.deb Depends)" = "libc6 (>= ${newest#GLIBC_})" ] ||
    { echo "the package depends on something else than $newest: $(dpkg-deb -f "$folder"/touchstone_*.deb Depends)" && exit 1; }
fi
mkdir "$folder/root"
tar -xzf "$folder"/touchstone-*.tar.gz -C "$folder/root" --strip-components 1
prefix=$folder/root
[ -x "$prefix/bin/touchstone" ] || prefix=$folder/root/usr
needed=$(ldd "$prefix/bin/touchstone" | awk '{print $1}' | grep -Ev '^(linux-vdso|libc|libm|/lib.*/ld-linux.*)[.]so' || true)
[ -z "$needed" ] || { echo "it needs more than the C library: $needed" && exit 1; }
cd "$folder"
env -i "$prefix/bin/touchstone" vectors check "$prefix/share/touchstone/vectors" --ops orientation,bounding_sphere
env -i "$prefix/bin/touchstone" soak orientation --cases 1000 --jobs 1
for library in libgmp-dev libmpfr-dev; do
  grep -qi gmp "$prefix/share/doc/touchstone/copyright" && [ -s "$prefix/share/doc/touchstone/linked/$library" ] ||
    { echo "no notice of $library" && exit 1; }
done
# Every source package that the notices name is in the bill of materials, with its version.
sed -n 's/^  \([a-z0-9.+-]*\) \([^ ]*\)$/\1 \2/p' "$prefix/share/doc/touchstone/copyright" | sort -u >"$folder/named"
[ "$(wc -l <"$folder/named")" -ge 8 ]
python3 -c 'import json, sys
for one in json.load(open(sys.argv[1]))["packages"]:
    print(one["name"], one["versionInfo"])' "$prefix/share/doc/touchstone/touchstone.spdx.json" | grep -v '^touchstone ' | sort >"$folder/listed"
diff "$folder/named" "$folder/listed"
