; Blocks on a table, and a hand that holds one of them.
(define (domain blocksworld)
  (:requirements :strips :typing)
  (:types block)
  (:predicates
    (on ?block ?below - block)
    (ontable ?block - block)
    (clear ?block - block)
    (holding ?block - block)
    (handempty))

  (:action pick-up
    :parameters (?block - block)
    :precondition (and (handempty) (clear ?block) (ontable ?block))
    :effect (and (holding ?block)
                 (not (handempty)) (not (clear ?block)) (not (ontable ?block))))

  (:action put-down
    :parameters (?block - block)
    :precondition (holding ?block)
    :effect (and (handempty) (clear ?block) (ontable ?block)
                 (not (holding ?block))))

  (:action stack
    :parameters (?block ?below - block)
    :precondition (and (holding ?block) (clear ?below))
    :effect (and (handempty) (clear ?block) (on ?block ?below)
                 (not (holding ?block)) (not (clear ?below))))

  (:action unstack
    :parameters (?block ?below - block)
    :precondition (and (handempty) (clear ?block) (on ?block ?below))
    :effect (and (holding ?block) (clear ?below)
                 (not (handempty)) (not (clear ?block)) (not (on ?block ?below)))))
