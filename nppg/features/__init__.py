"""Predicates that a domain does not have and policies want to test, derived from its types and its actions."""
