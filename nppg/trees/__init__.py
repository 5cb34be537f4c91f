"""Regression trees, what grows them from answers and targets, and the clauses that they are."""
