"""The speed table of docs/performance.md, which `python -m benchmarks` or `make bench` prints."""
