# docker build -t nppg . && docker run --rm -v "$PWD/runs:/nppg/runs" nppg train blocks_world --output runs/demo
# Debian 13's own SWI-Prolog is new enough, so ./setup has nothing to build here but janus-swi.
FROM debian:trixie-slim

RUN apt-get update \
    && apt-get install -y --no-install-recommends \
        ca-certificates gcc libc6-dev make python3-dev python3-venv swi-prolog-nox \
    && rm -rf /var/lib/apt/lists/*

WORKDIR /nppg
COPY . .
RUN ./setup

ENV PATH=/nppg/.venv/bin:$PATH
ENTRYPOINT ["nppg"]
CMD ["--help"]
