"""Reports: runs as one page that needs nothing else, their curves, what a policy was thinking."""
