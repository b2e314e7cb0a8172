# For the tests that need a real browser; read by their run.sh. in_browser_folder WORK PACKAGE FILE...: makes the folder WORK with playwright
# of PACKAGE's package.json and copies of the files, and goes there. $browser is the browser. Exit code 77 (skipped) where
# Chromium, node, npm or the package cannot be had.
browser=$(command -v chromium || command -v chromium-browser || true)
[ -n "$browser" ] || { echo "skipped: no chromium"; exit 77; }
for program in node npm; do
  command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done

in_browser_folder() {
  folder=$1
  package=$2
  shift 2
  mkdir -p "$folder"
  cp "$package/package.json" "$package/package-lock.json" "$@" "$folder"
  cd "$folder"
  [ -d node_modules/playwright-core ] || npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || {
    echo "skipped: npm ci failed, see $folder/npm.log"
    exit 77
  }
}
