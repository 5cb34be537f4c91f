"""`python -m nppg` is the command line."""

import sys

from nppg.cli import main

sys.exit(main())
