"""What people read: distilled rules, sentences, proofs, pictures of trees."""
