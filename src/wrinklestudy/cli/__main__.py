"""The command line as a module: `python -m wrinklestudy.cli`."""

import sys

from wrinklestudy.cli import main

if __name__ == "__main__":
    sys.exit(main())
