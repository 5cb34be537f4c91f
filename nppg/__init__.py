"""Relational reinforcement learning by non-parametric policy gradients."""
