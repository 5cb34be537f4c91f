"""What an agent acts in: domains in Prolog and environments of Gymnasium, opened by name."""
