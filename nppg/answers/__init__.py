"""What holds of a state and an action: the tests of a language bias, asked of Prolog or read off the facts."""
