# Everything happens in .venv and target; `make demo` and `make test` need no other set-up.

SHELL := /bin/bash
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.PHONY: help setup build dev wheel libclubface wheel-check sdist sdist-check demo test test-programs test-oldest test-newest test-beyond test-foreign test-wheel check wasm-check bench docs site site-test paper notebooks studio studio-build studio-test studio-open studio-figures golden benchmarks study mutants benchmark-data benchmark-identification benchmark-identification-speed fem-figures validation ball-fit ball-shear-fit strike-height response-fit face-spring identification-coverage capture-study capture-coverage fuzz kills release clean

VENV := .venv
BIN := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
PYTHON := $(BIN)/python
export VIRTUAL_ENV := $(CURDIR)/$(VENV)
export PYO3_PYTHON := $(CURDIR)/$(PYTHON)
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PIP_CONSTRAINT := $(CURDIR)/constraints-dev.txt
export PATH := $(CURDIR)/$(BIN):$(PATH)

RUST_SOURCES := $(wildcard Cargo.toml Cargo.lock crates/*/Cargo.toml) $(shell find crates -name '*.rs')
RUST_TESTED := --workspace --exclude clubface-python --exclude clubface-benches --locked
# A sample: every 500th error of the crates that compute, which takes minutes.
RUST_MUTANTS := --package clubface-math --package clubface-impact --package clubface-fem --profile release \
	--shard 7/500 --sharding round-robin --output target --minimum-test-timeout 120

# The studio needs Node 20.19 or newer and npm, which some systems package apart; without them, its part of the checks and
# tests is left out with a message.
NODE := $(shell command -v npm >/dev/null && node -p 'const [major, minor] = process.versions.node.split("."); +major > 20 || (+major === 20 && +minor > 18)' 2>/dev/null)
STUDIO_PACKAGES := studio/node_modules/.package-lock.json
STUDIO_DATA := studio/generated/equipment.json
STUDIO_DATA_SOURCES := $(wildcard studio/*.py) $(shell find python/clubface -name '*.py' -o -name '*.toml' -o -name '*.csv')
# The core for browsers in two parts: all but the finite elements, which is small, and everything.
WASM := target/browser/clubface.wasm
WASM_FEM := target/browser/clubface-fem.wasm
STUDIO_CORE := studio/generated/clubface.wasm studio/generated/clubface-fem.wasm
STUDIO_CHECKED := $(if $(filter true,$(NODE)),$(STUDIO_PACKAGES) $(STUDIO_DATA))
# What was built for browsers is built again where it is old, since the tests of the studio compute with it.
STUDIO_TESTED := $(if $(STUDIO_CHECKED),$(STUDIO_CHECKED) $(wildcard $(STUDIO_CORE)))

help: ## list the targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/\1|\2/p' $(MAKEFILE_LIST) | while IFS='|' read -r name text; do printf '%-32s %s\n' "$$name" "$$text"; done

setup: $(VENV)/.setup ## make the virtual environment; say which tools are missing
build: $(VENV)/.build ## compile the core and install the package into the virtual environment
dev: $(VENV)/.dev ## the same, and the tools that tests, checks and documentation need

$(VENV)/.setup: constraints-dev.txt scripts/find-tools.sh
	@python=$$(scripts/find-tools.sh) && $$python -m venv $(VENV)
	@$(PYTHON) -m pip install --quiet maturin
	@touch $@

# The packages of Python arrive while the core compiles.
$(VENV)/.build: $(VENV)/.setup pyproject.toml $(RUST_SOURCES)
	@$(PYTHON) scripts/requirements.py excel tables plots fem capture fit studio jax mujoco | $(PYTHON) -m pip install --quiet -r /dev/stdin & \
	$(BIN)/maturin develop --release --skip-install --quiet && wait $$!
	$(BIN)/maturin develop --release --quiet
	@scripts/fmi-library.sh release
	@touch $@

$(VENV)/.dev: $(VENV)/.build constraints-dev.txt
	@$(PYTHON) scripts/requirements.py dev | $(PYTHON) -m pip install --quiet -r /dev/stdin
	@touch $@

INTERPRETER ?=
PROFILE ?= dist
TARGET ?=
WHEEL ?=
RECORD ?=
NEWEST_WHEEL = $(or $(WHEEL),$$(ls -t target/wheels/*.whl | head -n 1))
WHEEL_CHECK = $(PYTHON) scripts/wheel_check.py $(if $(INTERPRETER),--python $(INTERPRETER)) $(if $(RECORD),--record)

# What links for other machines.
$(VENV)/.cross: $(VENV)/.setup constraints-dev.txt
	@$(PYTHON) -m pip install --quiet cargo-zigbuild ziglang
	@touch $@

wheel: studio-build $(if $(TARGET),$(VENV)/.cross) ## a wheel, optimised as a whole, with the built studio (TARGET=aarch64-unknown-linux-musl; INTERPRETER=python3.14t; PROFILE=release: sooner)
	$(if $(TARGET),rustup target add $(TARGET))
	INTERPRETER="$(INTERPRETER)" scripts/wheel.sh $(PROFILE) $(TARGET)

wheel-check: wheel ## the wheel in fresh environments outside the checkout: alone, as users install it, with every extra
	$(WHEEL_CHECK) "$(NEWEST_WHEEL)"

sdist: studio-build ## the sources as a package, with the built studio in it
	@rm -rf python/clubface/studio_site && cp -R studio/dist python/clubface/studio_site
	$(BIN)/maturin sdist --out target/wheels; status=$$?; rm -rf python/clubface/studio_site; exit $$status

sdist-check: sdist ## the same checks of the wheel that pip makes of it
	$(WHEEL_CHECK) "$$(ls -t target/wheels/*.tar.gz | head -n 1)"

PREFIX ?= /usr/local
libclubface: ## the C library with its header and the files of pkg-config and CMake, in PREFIX=/usr/local
	@scripts/install-libclubface.sh "$(PREFIX)"

demo: build ## the published tour averages by every model; tables and pictures in out/
	$(BIN)/clubface tour --averages all --output out/

test: build ## all tests; the last line is "N passed, N failed"
	@$(MAKE) --no-print-directory --silent --jobs 3 dev test-programs $(STUDIO_TESTED)
	@$(PYTHON) scripts/run_tests.py

# The tools of Python's tests arrive while those of Rust compile, whose errors the run of the tests counts.
test-programs: build
	-@cargo test --release $(RUST_TESTED) --no-run

PYTHONS ?= $(PYTHON)
PYTEST ?=
TEST_VERSIONS = $(PYTHON) scripts/test_versions.py $(@:test-%=%) $(PYTHONS) $(if $(WHEEL),--wheel $(WHEEL)) \
	$(if $(RECORD),--record) -- $(PYTEST)
test-oldest: dev ## the tests of Python on the lowest versions allowed (PYTHONS="python3.11 python3.13", PYTEST=tests/cli, RECORD=1)
	@$(TEST_VERSIONS)

test-newest: dev ## the same on the highest versions allowed
	@$(TEST_VERSIONS)

test-beyond: dev ## the same on the newest versions there are, whatever pyproject.toml allows
	@$(TEST_VERSIONS)

test-foreign: $(VENV)/.cross ## the tests of Rust as TARGET=aarch64-unknown-linux-gnu runs them, here by qemu or Wine; minutes (RECORD=1)
	rustup target add $(TARGET)
	$(PYTHON) scripts/foreign tests $(TARGET) $(if $(RECORD),--record)

FOREIGN_PYTHON ?=
test-wheel: $(VENV)/.cross ## the newest wheel (or WHEEL) in the Python of TARGET, here by qemu or Wine; minutes (PYTEST=tests/fem, RECORD=1)
	$(PYTHON) scripts/foreign wheel $(TARGET) "$(NEWEST_WHEEL)" --python "$(FOREIGN_PYTHON)" --pytest "$(PYTEST)" \
		$(if $(RECORD),--record)

check: dev $(STUDIO_CHECKED) ## formatting, lints, types, documentation
	cargo fmt --all --check
	cargo clippy --workspace --all-targets --locked -- -D warnings
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/python scripts/check_words.py
	$(BIN)/pyright --pythonpath $(PYTHON)
	$(BIN)/sphinx-build -W --keep-going -q -E docs docs/_build
	$(if $(STUDIO_CHECKED),npm --prefix studio run --silent check,@echo "the studio is not checked: that needs Node 20.19 or newer and npm")

docs: dev ## the documentation as web pages in docs/_build
	$(BIN)/sphinx-build -W --keep-going -q docs docs/_build
	@echo "docs/_build/index.html"

SITE := out/site
site: dev studio-build ## documentation and studio as one site in out/site, for servers and from files, without a network
	rm -rf $(SITE)
	mkdir -p $(SITE)
	cp -r studio/dist $(SITE)/studio
	npm --prefix studio run --silent build-from-file -- --outDir $(CURDIR)/$(SITE)/studio
	npm --prefix studio run --silent build-live -- --outDir $(CURDIR)/$(SITE)/studio
	$(BIN)/sphinx-build -W --keep-going -q -t site -d out/site-doctrees docs $(SITE)
	@echo "$(SITE)/index.html"

site-test: site ## every page of the site opened from its file in Chromium, as on a phone and on a desk, and the studio
	@scripts/find-browser.sh >/dev/null
	$(BROWSER) npm --prefix studio run --silent site-test

paper: dev ## the paper of four pages about clubface in out/paper.pdf, its numbers computed
	$(PYTHON) paper/build.py out

notebooks: dev ## run the notebooks again and store what they print and draw
	$(PYTHON) notebooks/run.py --update

$(WASM): WASM_FEATURES :=
$(WASM_FEM): WASM_FEATURES := fem
# One after the other, since cargo writes both to the same place.
$(WASM_FEM): $(WASM)
$(WASM) $(WASM_FEM): $(RUST_SOURCES) .cargo/config.toml studio/build/wasm.mjs
	rustup target add wasm32-unknown-unknown
	cargo build --profile wasm --locked --package clubface-c --no-default-features --features "$(WASM_FEATURES)" \
		--target wasm32-unknown-unknown
	@mkdir -p $(@D)
	node studio/build/wasm.mjs target/wasm32-unknown-unknown/wasm/clubface.wasm $@

wasm-check: build ## the core in WebAssembly: built, run in Node, compared with the package
	@command -v node >/dev/null || { echo "wasm-check needs Node 20 or newer" >&2; exit 1; }
	@$(MAKE) --no-print-directory $(WASM) $(WASM_FEM)
	$(PYTHON) scripts/wasm_check.py $(WASM) $(WASM_FEM)

$(STUDIO_PACKAGES): studio/package.json studio/package-lock.json
	@npm --prefix studio ci --prefer-offline --no-audit --no-fund --loglevel error
	@touch $@

$(STUDIO_DATA): $(VENV)/.build $(STUDIO_DATA_SOURCES)
	@$(PYTHON) studio/data.py studio/generated

$(STUDIO_CORE): studio/generated/%.wasm: target/browser/%.wasm
	@mkdir -p $(@D)
	cp $< $@

studio-build: build ## the studio, a site that computes in the browser, in studio/dist
	@test "$(NODE)" = true || { echo "the studio needs Node 20.19 or newer and npm" >&2; exit 1; }
	@$(MAKE) --no-print-directory $(STUDIO_PACKAGES) $(STUDIO_DATA) $(STUDIO_CORE)
	npm --prefix studio run --silent build

studio: studio-build ## the same, served on http://localhost:4173
	npm --prefix studio run --silent serve

BROWSER = CHROMIUM=$$(scripts/find-browser.sh)

studio-test: studio-build ## the studio in Debian's Chromium (CHROMIUM=/path of another): scenes, links, offline, numbers
	@scripts/find-browser.sh >/dev/null
	$(BROWSER) PYTHON=$(CURDIR)/$(PYTHON) npm --prefix studio run --silent browser-test

studio-open: studio-build ## every scene opened in Chromium once: the short part of studio-test
	@scripts/find-browser.sh >/dev/null
	$(BROWSER) npm --prefix studio run --silent open-test

studio-figures: studio-build ## the pictures of docs/studio.md, drawn again in Chromium
	@scripts/find-browser.sh >/dev/null
	$(BROWSER) SCREENSHOTS=screenshots npm --prefix studio run --silent screenshots
	$(PYTHON) docs/figures/studio.py studio/screenshots/docs

golden: dev ## the numbers that Rust, Python, the command line and the studio must compute alike, computed again
	$(PYTHON) scripts/golden_numbers.py

bench: dev ## speed, printed next to the computed results
	cargo bench --package clubface-benches --locked
	$(PYTHON) -m pytest benchmarks --benchmark-only

LULESH ?=
benchmarks: dev $(if $(filter true,$(NODE)),$(STUDIO_CORE)) ## the times of docs/benchmarks.md, measured here; four minutes of a quiet machine (LULESH=FOLDER, a checkout)
	$(PYTHON) benchmarks/measure.py
	$(if $(LULESH),$(PYTHON) benchmarks/lulesh.py "$(LULESH)")

study: dev ## the tests that take minutes; those of Rust with debug assertions and checks of overflow
	cargo test $(RUST_TESTED) -- --include-ignored
	$(PYTHON) -m pytest -m study

benchmark-data: build ## make the benchmark shots again from their recipe, bit for bit
	$(PYTHON) -m clubface.validation.benchmark_recipe

benchmark-identification: build ## identify every model on the benchmark shots: the tables of docs/findings.md; some 20 minutes, resumed
	@mkdir -p out
	$(PYTHON) studies/benchmark_findings.py out/benchmark-identification docs/findings.json
	$(PYTHON) docs/run.py --stamp docs/findings.json

benchmark-identification-speed: dev ## time of Caldwell and McPhee's whole identification of the volumetric driver, and its cost
	$(PYTHON) benchmarks/identification_speed.py

fem-figures: dev ## the figures of docs/finite-elements, computed again; some ten minutes
	$(PYTHON) benchmarks/fem_figures.py

validation: build ## models compared with published figures: the picture and the finite elements of docs/which-model.md; minutes
	$(PYTHON) docs/figures/validation.py
	$(PYTHON) docs/run.py --stamp docs/validation-fem.json

ball-fit: dev ## fit the core of the ball modern-2026 to published plate tests again, with intervals; a minute or two
	$(PYTHON) studies/ball_fit.py

ball-shear-fit: dev ## fit the ball modern to plates, start angles and spins at measured launch, with intervals; minutes
	$(PYTHON) studies/ball_shear_fit.py
	$(PYTHON) docs/run.py --stamp docs/finite-elements/ball-fit.json

strike-height: dev ## what a low strike changes in the spin of an iron, cause by cause: the tables of its page; two minutes
	$(PYTHON) studies/strike_height.py
	$(PYTHON) docs/run.py --stamp docs/finite-elements/strike-height.json

BALL ?= modern
response-fit: dev ## the model response for a ball (BALL=modern, or the path of a file): strikes, fit, residuals; half an hour
	$(PYTHON) studies/response_fit.py $(BALL) studies/response

face-spring: dev ## drivers of shells beside a spring behind the face: the figures of docs/models/response.md
	$(PYTHON) studies/face_spring.py
	$(PYTHON) docs/run.py --stamp studies/face_spring.json

identification-coverage: dev ## how often intervals of identified parameters hold the truth, over 400 repeats; ten minutes
	PYTHONPATH=tests/helpers $(PYTHON) studies/identification_coverage.py
	$(PYTHON) docs/run.py --stamp studies/identification_coverage.json

mutants: dev ## errors planted in a sample of the package and the core: how many no test notices; half an hour
	$(PYTHON) scripts/mutants
	@command -v cargo-mutants >/dev/null || cargo install --locked --quiet cargo-mutants@27.1.0 --root target/tools
	PATH="$(CURDIR)/target/tools/bin:$$PATH" cargo mutants $(RUST_MUTANTS)

capture-study: build ## errors of motion capture on synthetic swings: tables and picture of its page; minutes
	$(PYTHON) docs/figures/capture_study.py
	$(PYTHON) docs/run.py --stamp docs/capture-study.json

capture-coverage: dev ## errors and coverage of motion capture on 200 to 400 synthetic swings; ten minutes
	$(PYTHON) -m pytest -q -m study tests/capture/test_study.py tests/capture/test_bare.py

COUNT ?= 1000000
SEED ?= 0
fuzz: dev ## damaged files for every reader (COUNT=1000000, a night; or SECONDS=3600, WORKERS=1; SEED=0); findings in out/fuzz
	$(PYTHON) tests/fuzz/fuzz.py --count $(COUNT) --seed $(SEED) --seconds $(or $(SECONDS),inf) $(if $(WORKERS),--workers $(WORKERS))

KILLS ?= 50
kills: dev ## kill every long command at random moments (KILLS=50 each, or SECONDS=3600), resume it, compare the bytes
	$(PYTHON) studies/kills.py $(KILLS) --seconds $(or $(SECONDS),inf)

release: $(VENV)/.setup ## check that VERSION=0.2.0 is the same everywhere and nothing is left to commit, and set its tag
	$(PYTHON) scripts/release.py "$(VERSION)"

clean: ## remove everything that was built
	rm -rf $(VENV) target out docs/_build studio/node_modules studio/generated studio/dist studio/screenshots .pytest_cache .ruff_cache .hypothesis .benchmarks
