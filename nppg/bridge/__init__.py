"""SWI-Prolog: finding, starting and asking it, terms as data; and the files that nppg ships and writes."""
