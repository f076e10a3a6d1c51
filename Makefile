# make figures and make test are all that is needed on a fresh machine; both set up .venv first.

PYTHON ?= python3
CORES ?= all
# make report CONFIG=config/quick.yaml REPORT=report/quick.html
CONFIG ?=
REPORT ?= report/report.html
ARCHIVE ?= archive/study.zip
EXPLORER ?= explorer/explorer.html
FILM ?= explorer/film.$(if $(shell command -v ffmpeg),mp4,gif)
BIN := .venv/bin
READY := $(BIN)/.ready
LOCK := requirements/lock.txt
PIP := $(BIN)/python -m pip --disable-pip-version-check
SNAKEMAKE := $(BIN)/snakemake --cores $(CORES) --quiet host rules

# jobs and tests run side by side, each on one thread
ONE_THREAD := OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1

.DEFAULT_GOAL := help
.PHONY: help env figures quick beyond literature imperfections report archive explorer film docs test test-fuzz test-kill test-slurm verify \
	verify-solid bench bench-plan lint schema lock

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /  make \1	/p' $(MAKEFILE_LIST)

env: $(READY) ## set up .venv with the locked requirements and this package

$(READY): $(LOCK) pyproject.toml
	@$(PYTHON) -c 'import sys; v = sys.version.split()[0]; sys.exit(sys.version_info < (3, 11) \
		and f"Python {v} is too old, 3.11 is needed: make PYTHON=python3.11 ...")'
	$(PYTHON) -m venv .venv
	$(PIP) install --quiet --requirement $(LOCK)
	$(PIP) install --quiet --no-deps --editable .
	$(BIN)/python -m compileall -q src
	@touch $@

figures: $(READY) ## run the default study (config.yaml) on all cores: figures/
	$(SNAKEMAKE)

quick: $(READY) ## run the same on a coarse mesh with three strains: figures/quick/
	$(SNAKEMAKE) --configfile config/quick.yaml

beyond: $(READY) ## run the study beyond the paper (config/beyond.yaml): figures/beyond/, docs/beyond.md
	$(SNAKEMAKE) --configfile config/beyond.yaml
	@mkdir -p docs/beyond
	cp results/beyond/claims/claims.md docs/beyond.md
	cp figures/beyond/*.png docs/beyond/

literature: $(READY) ## run the study of what others published (config/literature.yaml): docs/literature_study.md
	$(SNAKEMAKE) --configfile config/literature.yaml
	@mkdir -p docs/literature
	cp results/literature/claims/claims.md docs/literature_study.md
	cp figures/literature/*.png docs/literature/

imperfections: $(READY) ## run the study of imperfections (config/imperfections.yaml): docs/imperfections.md
	$(SNAKEMAKE) --configfile config/imperfections.yaml
	@mkdir -p docs/imperfections
	cp results/imperfections/claims/claims.md docs/imperfections.md
	cp figures/imperfections/*.png docs/imperfections/

report: $(READY) ## run the study and put figures, claims and run times into report/report.html
	$(SNAKEMAKE) $(CONFIG:%=--configfile %)
	@mkdir -p $(dir $(REPORT))
	$(SNAKEMAKE) $(CONFIG:%=--configfile %) --report $(REPORT)

# make archive CONFIG=config/quick.yaml ARCHIVE=archive/quick.zip
archive: $(READY) ## run the study and put it, its program and its checksums into archive/study.zip (RO-Crate)
	$(SNAKEMAKE) $(CONFIG:%=--configfile %)
	$(BIN)/python workflow/archive.py $(or $(CONFIG),config.yaml) $(ARCHIVE)

# make explorer CONFIG=config/beyond.yaml EXPLORER=explorer/beyond.html
explorer: $(READY) ## run the study and write a page to play with its states: explorer/explorer.html
	$(SNAKEMAKE) $(CONFIG:%=--configfile %)
	$(BIN)/wrinklestudy explore --config $(or $(CONFIG),config.yaml) --output $(EXPLORER)

film: $(READY) ## compute the paper's sheet from birth to decay as a film: explorer/film.gif (.mp4 with ffmpeg)
	$(BIN)/wrinklestudy film --material latex --aspect 2 --thickness 1e-3 --jobs 2 --overwrite --output $(FILM)

docs: $(READY) ## build the site from docs/, with the figures that are there: site/index.html
	$(BIN)/sphinx-build --fresh-env --fail-on-warning --keep-going --quiet docs site

test: $(READY) ## run the tests, with the quick study as one of them
	$(ONE_THREAD) $(BIN)/python -m pytest --numprocesses auto --dist loadgroup --no-loadscope-reorder

test-fuzz: $(READY) ## throw 10,000 broken configs, files, paths and command lines at the program (half an hour)
	$(ONE_THREAD) FUZZ_EXAMPLES=10000 $(BIN)/python -m pytest tests/fuzz --numprocesses auto --dist load -q

test-kill: $(READY) ## kill runs of a small study a hundred times at random moments (ten minutes)
	$(ONE_THREAD) KILLS=100 KILL_SEED=$$(date +%j) $(BIN)/python -m pytest -q tests/workflow/test_kills.py

verify: $(READY) ## compute the evidence that the numbers are right: docs/verification.md
	$(SNAKEMAKE) --snakefile verification/Snakefile

verify-solid: $(READY) ## compute the tables of the solid anew, large meshes too (ten minutes): verification/solid_*.csv
	$(ONE_THREAD) $(BIN)/python -m verification.solid_run

bench: $(READY) ## time the solver and the whole study (half an hour): docs/performance.md
	@mkdir -p results/bench
	$(ONE_THREAD) $(BIN)/python -m pytest benchmarks/bench_solver.py -p no:xdist \
		--override-ini addopts= --benchmark-json results/bench/solver.json
	$(BIN)/python benchmarks/bench_study.py results/bench/study.json
	$(BIN)/python benchmarks/bench_mesh.py results/bench/mesh.json
	$(BIN)/python benchmarks/bench_thin.py results/bench/thin.json
	$(BIN)/python benchmarks/report.py results/bench docs/performance.md

bench-plan: $(READY) ## time the planning of up to 50,000 states (ten minutes): docs/planning.md
	$(BIN)/python benchmarks/bench_plan.py docs/planning.md

test-slurm: $(READY) ## run the quick study through a Slurm cluster of one node (root, Debian's slurm-wlm and munge)
	WRINKLESTUDY_SLURM=1 $(ONE_THREAD) $(BIN)/python -m pytest tests/workflow/slurm --numprocesses 0 -v

lint: $(READY) ## check style, types and workflow
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/snakefmt --check Snakefile workflow verification
	$(BIN)/python workflow/lint.py

schema: $(READY) ## write config/schema.json, from which editors check a config
	$(BIN)/python -m wrinklestudy.study.config.schema config/schema.json

lock: ## resolve the newest requirements that pyproject.toml allows
	requirements/refresh $(PYTHON)
