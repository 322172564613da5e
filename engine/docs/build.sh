#!/usr/bin/env bash
# Builds the documentation's site: engine/docs/build.sh, then open out/docs/index.html
# Installs what is missing. A warning of Doxygen is an error.
# shellcheck source-path=SCRIPTDIR source=../../tests/lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/../../tests/lib.sh"

step "Packages"
bash "$rgimp_root/tests/install_dependencies.sh" doxygen graphviz libjs-mathjax
cd "$rgimp_root"
rm --recursive --force out/docs
mkdir --parents out/docs/mathjax
step "Doxygen"
doxygen engine/docs/Doxyfile

# The parts of MathJax that the pages load, so that they need no network.
step "MathJax"
(cd /usr/share/javascript/mathjax &&
  cp --recursive --dereference --parents MathJax.js extensions jax/element jax/input/TeX \
    jax/output/HTML-CSS fonts/HTML-CSS/TeX/woff "$rgimp_root/out/docs/mathjax")
echo "The pages are in $rgimp_root/out/docs/index.html"
