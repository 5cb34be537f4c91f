; A cart brings books back to their shelves, one at a time.
(define (domain library)
  (:requirements :strips :typing :negative-preconditions)
  (:types book shelf)
  (:predicates
    (at ?b - book ?s - shelf)
    (cart-at ?s - shelf)
    (carries ?b - book)
    (cart-empty))

  (:action push
    :parameters (?from ?to - shelf)
    :precondition (and (cart-at ?from) (not (cart-at ?to)))
    :effect (and (not (cart-at ?from)) (cart-at ?to)))

  (:action take
    :parameters (?b - book ?s - shelf)
    :precondition (and (cart-at ?s) (at ?b ?s) (cart-empty))
    :effect (and (not (at ?b ?s)) (not (cart-empty)) (carries ?b)))

  (:action put
    :parameters (?b - book ?s - shelf)
    :precondition (and (cart-at ?s) (carries ?b))
    :effect (and (at ?b ?s) (cart-empty) (not (carries ?b)))))
