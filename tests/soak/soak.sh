#!/usr/bin/env bash
# Mesh random models: soak.sh SCRIPT PROGRAM OPTION... Exit status 77 (skipped) where the script or
# what it needs is not there.
set -euo pipefail

script=$1
shift
if [ ! -f "$script" ]; then
  echo "skipped: there is no $script"
  exit 77
fi
if ! /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
  echo "skipped: python3-numpy is not installed"
  exit 77
fi
exec /usr/bin/python3 "$script" "$@"
