"""What a domain's own words do not say: predicates derived from its types and clauses, and which of them are worth testing."""
