#!/bin/sh
# All set-up on a bare Debian 12, then the tests: installs what is missing, builds, runs every test, among them three
# projects that use the installed package. Nothing outside the build folder is touched but the system's packages.
set -eu
cd "$(dirname "$0")/.."

cmake/install_packages.sh
cmake --preset release
cmake --build --preset release
ctest --preset release
