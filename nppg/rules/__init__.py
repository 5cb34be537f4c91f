"""What people read: distilled rules, proofs, pages of trees, where policies differ."""
