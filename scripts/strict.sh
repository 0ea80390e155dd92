# Sourced by the scripts: the first command that fails ends them, and they say which and where.
set -Eeuo pipefail
trap 'status=$?; echo "${BASH_SOURCE[0]}: line $LINENO: ended with $status: $BASH_COMMAND" >&2; exit $status' ERR
