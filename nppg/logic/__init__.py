"""Queries: variables, literals, θ-subsumption and normal forms. It knows neither Prolog nor files."""
