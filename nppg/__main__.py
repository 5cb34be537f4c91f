"""`python -m nppg` is the command line."""

import sys

from nppg.cli.main import main

sys.exit(main())
