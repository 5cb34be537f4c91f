"""PDDL: read with places, checked, and written as a domain file, its language bias and its problems."""
